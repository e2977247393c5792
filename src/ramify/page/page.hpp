#pragma once

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

struct PageTable {
  std::string caption;
  Table table;
};

struct PagePicture {
  std::string svg;          ///< a whole document
  std::string alternative;  ///< what it shows, for whoever does not see it
  std::string caption;
};

/// What is typed to get the same again, a command a line.
struct PageCommands {
  std::vector<std::string> lines;
};

using PageBlock = std::variant<PageParagraph, PageList, PageTable, PagePicture, PageCommands>;

struct PageSection {
  std::string heading;
  std::vector<PageBlock> blocks;
  std::vector<PageSection> parts;  ///< one level lower; four levels at most
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
