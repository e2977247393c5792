#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/number_style.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {

/// Cuts a table of numbers and names into fields, line by line: fields are parts of the text, so that they
/// carry their place with them.
///
/// Fields are parted by semicolons, tabs, bars or commas: the one that parts the first two rows into as many
/// fields, in this order where several do; where the first row has none of them by white space. White space
/// around a field is left out, and so are quotes around a whole one. Lines that are empty, or hold separators
/// alone, and lines that begin with # are skipped. Throws Error for a quote that is never closed on its line,
/// and a row of more than 10,000 fields.
class DelimitedRows {
 public:
  /// What parts the fields.
  enum class Separator {
    found,   ///< as above
    points,  ///< of SWC: semicolons or commas where there are six of them that are no decimal marks, else
             ///< white space of any kind; what follows a # is a comment
  };

  explicit DelimitedRows(SourceText source, Separator separator = Separator::found)
      : source_(source), lines_(source.text()), kind_(separator) {}

  /// Steps to the next row; false after the last.
  bool next();

  const std::vector<std::string_view>& fields() const { return fields_; }
  std::string_view line() const { return lines_.line(); }
  const SourceText& source() const { return source_; }
  /// Of the rows that were read; 0 before the first, ' ' for white space.
  char separator() const { return separator_; }

  /// The fields of the last line with a # before the first row, without that: where a table has no header, a
  /// comment may be one.
  std::vector<std::string_view> commented_header() const;

 private:
  char separator_of(std::string_view line) const;
  std::string_view next_line();
  void cut_line(std::string_view line);
  void cut(std::string_view line);
  void cut_at_spaces(std::string_view line);
  void add_field(std::string_view field);
  std::string_view quoted(std::string_view from) const;

  SourceText source_;
  LineCursor lines_;
  Separator kind_;
  char separator_ = 0;  // ' ' for white space, 0 before the first row
  std::string_view comment_;
  std::vector<std::string_view> fields_;
};

/// How the numbers in these columns are written, from the row where `rows` stands to the last. O(text) where
/// the fields may hold commas.
NumberStyle style_of(DelimitedRows rows, const std::vector<std::optional<std::size_t>>& columns);

/// A finite number in a field. Throws Error with the field's place, naming the column, where it is none, or
/// can be read two ways.
double number_in(const SourceText& source, const NumberStyle& style, std::string_view field,
                 std::string_view column);

/// The same; NaN where there is none (is_missing).
double number_or_none(const SourceText& source, const NumberStyle& style, std::string_view field,
                      std::string_view column);

}  // namespace ramify
