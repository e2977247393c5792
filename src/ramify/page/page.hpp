#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ramify/io/table.hpp"

namespace ramify {

// What a page is made of. All texts are plain UTF-8: what is markup in HTML or Markdown, writers escape.

struct PageParagraph {
  std::string text;
};

struct PageList {
  std::vector<std::string> items;
};

/// How a field stands out. Colour never says anything alone: the field's own words stand.
enum class PageTone : std::uint8_t { plain, good, bad, open };

/// A column whose fields stand out, each in the tone of its row.
struct PageBadges {
  std::string column;
  std::vector<PageTone> tones;
};

struct PageTable {
  std::string caption;
  Table table;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::vector<std::string> links = {};  ///< row by row, the anchor to which the first field leads; or none
  PageBadges badges = {};
  /// Columns by whose values rows may be picked, where the form of the page can do that: without scripts.
  std::vector<std::string> filters = {};
  // NOLINTEND(readability-redundant-member-init)
};

struct PagePicture {
  std::string svg;          ///< a whole document
  std::string alternative;  ///< what it shows, for whoever does not see it
  std::string caption;
};

/// A picture in a file beside the page, which leads to another: a thumbnail.
struct PageThumbnail {
  std::string file;
  std::string leads_to;     ///< file
  std::string alternative;  ///< what it shows, for whoever does not see it
  std::string caption;
};

/// What is typed to get the same again, a command a line.
struct PageCommands {
  std::vector<std::string> lines;
};

/// A text that stands as it is, line by line: a config.
struct PageVerbatim {
  std::string label;  ///< what it is
  std::string text;
};

using PageBlock =
    std::variant<PageParagraph, PageList, PageTable, PagePicture, PageThumbnail, PageCommands, PageVerbatim>;

struct PageSection {
  std::string heading;
  std::vector<PageBlock> blocks;
  std::vector<PageSection> parts;  ///< one level lower; four levels at most
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::string anchor = {};  ///< by which links find it, one on the page; empty: a number
  std::string label = {};   ///< in the contents; empty: the heading
  // NOLINTEND(readability-redundant-member-init)
};

/// One page for reading, as a value: whoever makes it knows nothing of markup, and its writers
/// (html_writer.hpp, markdown_writer.hpp) nothing of what is in it.
struct Page {
  std::string title;
  std::vector<PageBlock> lead;  ///< before the first section
  std::vector<PageSection> sections;
  std::vector<PageBlock> colophon;  ///< what made it
};

}  // namespace ramify
