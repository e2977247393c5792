#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {

/// Cuts a table of numbers and names into fields, line by line: fields are parts of the text, so that they
/// carry their place with them.
///
/// Fields are parted by commas, tabs or semicolons, whichever the first row has, else by white space; white
/// space around a field is left out, and so are quotes around a whole one. Empty lines and lines that begin
/// with # are skipped. Throws Error for a quote that is never closed on its line,
/// and a row of more than 10,000 fields.
class DelimitedRows {
 public:
  explicit DelimitedRows(SourceText source) : source_(source), lines_(source.text()) {}

  /// Steps to the next row; false after the last.
  bool next();

  const std::vector<std::string_view>& fields() const { return fields_; }
  std::string_view line() const { return lines_.line(); }
  const SourceText& source() const { return source_; }

 private:
  void cut(std::string_view line);
  void cut_at_spaces(std::string_view line);
  void add_field(std::string_view field);
  std::string_view quoted(std::string_view from) const;

  SourceText source_;
  LineCursor lines_;
  char separator_ = 0;  // ' ' for white space, 0 before the first row
  std::vector<std::string_view> fields_;
};

/// A finite number in a field. Throws Error with the field's place, naming the column, where it is none.
double number_in(const SourceText& source, std::string_view field, std::string_view column);

/// The same; NaN for an empty field, NA and NaN.
double number_or_none(const SourceText& source, std::string_view field, std::string_view column);

}  // namespace ramify
