#include "ramify/io/csv_writer.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

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

void append_row(std::string& text, const std::vector<std::string>& fields) {
  // One empty field would be an empty line, which readers skip.
  const bool only_empty = fields.size() == 1 && fields.front().empty();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text += ',';
    append_field(text, fields[i], only_empty || needs_quotes(fields[i]));
  }
  text += '\n';
}

}  // namespace

std::string write_csv(const Table& table) {
  std::vector<std::string> fields = table.columns();
  std::string text;
  append_row(text, fields);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    std::ranges::transform(table.row(i), fields.begin(), to_text);
    append_row(text, fields);
  }
  return text;
}

}  // namespace ramify
