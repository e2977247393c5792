#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify::detail {

/// What stands in an MTG file before its entities.
struct MtgHeader {
  std::map<std::string_view, unsigned> scales;  ///< of every class
  std::size_t code_columns =
      0;  ///< the first ones of a line, which hold entities; all where it has no features
  // Columns of the features that are read.
  std::optional<std::size_t> length, radius, diameter, x, y, z;
  std::vector<std::string_view> ignored;  ///< names of the other features
  std::size_t columns = 0;                ///< up to the last that has a name
};

/// Reads it; afterwards `lines` stands at the line of the column names. Throws Error where a part is missing,
/// or the code is not FORM-A.
MtgHeader read_mtg_header(const SourceText& source, LineCursor& lines);

/// The fields of a line between tabs, white space around them left out, and comments: a # and what follows it
/// up to the next tab.
std::vector<std::string_view> mtg_fields(std::string_view line);

}  // namespace ramify::detail
