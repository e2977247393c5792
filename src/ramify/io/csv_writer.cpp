#include "ramify/io/csv_writer.hpp"

#include <ostream>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

bool needs_quotes(std::string_view field) {
  // A leading # would be read back as a comment.
  return field.find_first_of(",\"\r\n") != std::string_view::npos || field.starts_with('#');
}

void append_field(std::string& text, std::string_view field, bool quoted) {
  if (!quoted) {
    text += field;
    return;
  }
  text += '"';
  for (const char c : field) {
    if (c == '"') text += '"';
    text += c;
  }
  text += '"';
}

}  // namespace

void append_csv_row(std::string& text, std::span<const std::string> fields) {
  RAMIFY_EXPECTS(!fields.empty());
  // One empty field would be an empty line, which readers skip.
  const bool only_empty = fields.size() == 1 && fields.front().empty();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text += ',';
    append_field(text, fields[i], only_empty || needs_quotes(fields[i]));
  }
  text += '\n';
}

void write_csv_row(std::ostream& stream, std::span<const std::string> fields) {
  std::string text;
  append_csv_row(text, fields);
  stream << text;
}

void CsvTable::add(std::vector<std::string> row) {
  RAMIFY_EXPECTS(row.size() == header_.size());
  rows_.push_back(std::move(row));
}

std::string CsvTable::text() const {
  std::string text;
  append_csv_row(text, header_);
  for (const auto& row : rows_) append_csv_row(text, row);
  return text;
}

}  // namespace ramify
