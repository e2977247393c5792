#include "ramify/io/text_writer.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <vector>

#include "ramify/core/utf8.hpp"

namespace ramify {
namespace {

constexpr std::size_t gap = 2;
constexpr std::size_t least_last_width = 24;

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    if (end > 0) found.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return found;
}

/// Lines of at most width characters, cut at spaces; a longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  for (const auto word : words(text)) {
    if (!lines.back().empty() && character_count(lines.back()) + 1 + character_count(word) > width)
      lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
  }
  return lines;
}

struct Column {
  std::size_t width;
  bool right;
};

/// Rows of fields as text.
std::vector<std::vector<std::string>> texts_of(const Table& table) {
  std::vector<std::vector<std::string>> rows(table.rows());
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::ranges::transform(table.row(i), std::back_inserter(rows[i]), to_text);
  return rows;
}

std::vector<Column> measure(const Table& table, const std::vector<std::vector<std::string>>& rows) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    Column column{character_count(table.columns()[c]), table.holds_numbers(c)};
    for (const auto& row : rows) column.width = std::max(column.width, character_count(row[c]));
    columns.push_back(column);
  }
  return columns;
}

void limit_last(std::vector<Column>& columns, std::size_t width) {
  std::size_t before = 0;
  for (std::size_t c = 0; c + 1 < columns.size(); ++c) before += columns[c].width + gap;
  const std::size_t room = width > before ? width - before : 0;
  columns.back().width = std::min(columns.back().width, std::max(room, least_last_width));
}

void append_line(std::string& text, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  text += line + '\n';
}

void append_row(std::string& text, const std::vector<Column>& columns, const std::vector<std::string>& row) {
  std::string line;
  for (std::size_t c = 0; c + 1 < columns.size(); ++c) {
    const std::string blank(columns[c].width - character_count(row[c]), ' ');
    line += columns[c].right ? blank + row[c] : row[c] + blank;
    line.append(gap, ' ');
  }
  const std::size_t indent = character_count(line);
  const Column& last = columns.back();
  for (const auto& part : wrapped(row.back(), last.width)) {
    const std::size_t size = character_count(part);
    if (last.right && size < last.width) line.append(last.width - size, ' ');
    append_line(text, line + part);
    line.assign(indent, ' ');
  }
}

}  // namespace

std::string write_text(const Table& table, std::size_t width) {
  const auto rows = texts_of(table);
  std::vector<Column> columns = measure(table, rows);
  if (width > 0) limit_last(columns, width);
  std::vector<std::string> rule;
  for (const auto& column : columns) rule.emplace_back(column.width, '-');
  std::string text;
  append_row(text, columns, table.columns());
  append_row(text, columns, rule);
  for (const auto& row : rows) append_row(text, columns, row);
  return text;
}

}  // namespace ramify
