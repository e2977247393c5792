#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ramify/core/utf8.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify::detail {

/// Cuts RFC 4180 text into rows of fields, keeping count of line and column.
class CsvScanner {
 public:
  CsvScanner(std::string_view text, std::string_view name) : text_(text), name_(name) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  }

  /// Skips lines that begin with # and empty ones.
  void skip_comments() {
    while (!done() && (peek() == '#' || at_line_end())) {
      while (!done() && !at_line_end()) advance();
      take_line_end();
    }
  }

  /// The next row that is not an empty line; nothing at the end.
  std::optional<std::vector<CsvField>> next_row() {
    while (take_line_end()) {
    }
    if (done()) return std::nullopt;
    std::vector<CsvField> row;
    for (;;) {
      row.push_back(next_field());
      if (done() || take_line_end()) return row;
      if (peek() != ',')
        fail("text after a closing quote", "a quoted field ends at its quote", "double quotes inside it");
      advance();
    }
  }

  SourceLocation here() const { return {std::string(name_), line_, column_}; }

 private:
  bool done() const { return position_ == text_.size(); }
  char peek() const { return text_[position_]; }
  bool at_line_end() const { return text_.substr(position_).starts_with("\r\n") || peek() == '\n'; }

  void advance() {
    const char byte = text_[position_++];
    if (byte == '\n') {
      ++line_;
      column_ = 1;
    } else if (begins_character(byte)) {
      ++column_;
    }
  }

  bool take_line_end() {
    if (done() || !at_line_end()) return false;
    if (peek() == '\r') advance();
    advance();
    return true;
  }

  CsvField next_field() {
    CsvField field{{}, line_, column_};
    if (!done() && peek() == '"') {
      quoted_text(field);
      return field;
    }
    while (!done() && peek() != ',' && !at_line_end()) {
      if (peek() == '"')
        fail("a quote inside a field", "only a quoted field may hold quotes", "quote the whole field");
      if (peek() == '\r')
        fail("a carriage return alone", "lines end in \\n or \\r\\n", "save the file with such lines");
      field.text += peek();
      advance();
    }
    return field;
  }

  void quoted_text(CsvField& field) {
    const SourceLocation start = here();
    advance();
    for (;;) {
      if (done())
        throw error_at(start, "a quote that is never closed", "the field runs to the end of the file",
                       "close it");
      const char c = peek();
      advance();
      if (c == '"') {
        if (done() || peek() != '"') return;
        advance();
      }
      field.text += c;
    }
  }

  [[noreturn]] void fail(std::string_view problem, std::string_view why, std::string_view remedy) const {
    throw error_at(here(), problem, why, remedy);
  }

  std::string_view text_;
  std::string_view name_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 1;
};

}  // namespace ramify::detail
