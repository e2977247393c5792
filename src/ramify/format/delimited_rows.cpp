#include "ramify/format/delimited_rows.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ramify/text/trimmed.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

constexpr std::string_view blanks = " \t\v\f";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// How often a line has a separator outside of quotes.
std::size_t separators_in(std::string_view line, char separator) {
  std::size_t count = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == separator && !quoted) ++count;
  }
  return count;
}

/// "0,5", "-,25e0": a number whose comma is a decimal mark, quoted or not.
bool has_decimal_comma(std::string_view piece) {
  if (piece.size() > 2 && piece.front() == '"' && piece.back() == '"')
    piece = piece.substr(1, piece.size() - 2);
  return piece.find_first_not_of("0123456789+-,eE") == std::string_view::npos && piece.back() != ',' &&
         std::ranges::count(piece, ',') == 1;
}

/// Whether white space parts a line into so many fields or more, every comma in it being a decimal mark. In
/// "1 ,2 ,3" and "1, 2, 3" the commas part fields.
bool is_parted_by_blanks(std::string_view line, std::size_t fields) {
  std::size_t pieces = 0;
  for (std::size_t begin = line.find_first_not_of(blanks); begin < line.size(); ++pieces) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::string_view piece = line.substr(begin, end - begin);
    const bool has_comma = piece.find(',') != std::string_view::npos;
    if (has_comma && (!has_decimal_comma(piece) || (pieces == 1 && piece.front() == ','))) return false;
    begin = line.find_first_not_of(blanks, end);
  }
  return pieces >= fields;
}

/// Of SWC.
char separator_of_points(std::string_view line) {
  constexpr std::size_t fields = 7;
  line = line.substr(0, line.find('#'));
  if (separators_in(line, ';') >= fields - 1) return ';';
  return separators_in(line, ',') >= fields - 1 && !is_parted_by_blanks(line, fields) ? ',' : ' ';
}

bool is_nothing(std::string_view line) {
  return line.find_first_not_of(" \t\v\f,;|") == std::string_view::npos;
}

}  // namespace

std::string_view DelimitedRows::next_line() {
  while (lines_.next()) {
    const std::string_view line = lines_.line();
    if (is_nothing(line)) continue;
    const auto first = line.find_first_not_of(blanks);
    if (line[first] != '#') return line;
    if (separator_ == 0) comment_ = line.substr(first + 1);
  }
  return {};
}

char DelimitedRows::separator_of(std::string_view line) const {
  if (kind_ == Separator::points) return separator_of_points(line);
  DelimitedRows ahead(*this);
  ahead.separator_ = ' ';
  const std::string_view second = ahead.next_line();
  char best = ' ';
  for (const char c : {',', '|', '\t', ';'}) {
    const std::size_t count = separators_in(line, c);
    if (count == 0 || (c == ',' && is_parted_by_blanks(line, 2))) continue;
    const bool parts_both = second.empty() || separators_in(second, c) == count;
    if (best == ' ' || parts_both) best = c;
  }
  return best;
}

bool DelimitedRows::next() {
  const std::string_view line = next_line();
  if (line.empty()) return false;
  if (separator_ == 0) separator_ = separator_of(line);
  cut_line(kind_ == Separator::points ? line.substr(0, line.find('#')) : line);
  return true;
}

std::vector<std::string_view> DelimitedRows::commented_header() const {
  constexpr std::size_t longest = 1000;
  const std::size_t begin = comment_.find_first_not_of('#');
  if (begin == std::string_view::npos || comment_.size() > longest ||
      comment_.find('"') != std::string_view::npos)
    return {};
  DelimitedRows header(*this);
  header.cut_line(comment_.substr(begin));
  return header.fields_;
}

void DelimitedRows::cut_line(std::string_view line) {
  fields_.clear();
  if (separator_ == ' ') {
    cut_at_spaces(line);
  } else {
    cut(line);
  }
}

void DelimitedRows::add_field(std::string_view field) {
  constexpr std::size_t most = 10'000;
  if (fields_.size() == most)
    throw source_.error(field, "a row of more than 10000 fields", "this is no table of a tree",
                        "give a row to every node");
  fields_.push_back(field);
}

void DelimitedRows::cut_at_spaces(std::string_view line) {
  for (std::size_t begin = line.find_first_not_of(blanks); begin < line.size();) {
    if (line[begin] == '"') {
      add_field(quoted(line.substr(begin)));
      begin += fields_.back().size() + 2;
    } else {
      const auto blank =
          std::find_if(line.begin() + static_cast<std::ptrdiff_t>(begin), line.end(), is_blank);
      const auto end = static_cast<std::size_t>(blank - line.begin());
      add_field(line.substr(begin, end - begin));
      begin = end;
    }
    begin = line.find_first_not_of(blanks, begin);
  }
}

void DelimitedRows::cut(std::string_view line) {
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t first = line.find_first_not_of(separator_ == '\t' ? " " : " \t", begin);
    if (first < line.size() && line[first] == '"') {
      add_field(quoted(line.substr(first)));
      const std::size_t after = first + fields_.back().size() + 2;
      begin = std::min(line.find(separator_, after), line.size()) + 1;
      if (!trimmed(line.substr(after, begin - 1 - after)).empty())
        throw source_.error(line.substr(after), "text after a closing quote",
                            "a quoted field ends at its quote", "quote the whole field");
      continue;
    }
    const std::size_t end = std::min(line.find(separator_, begin), line.size());
    const std::string_view field = line.substr(begin, end - begin);
    const std::string_view inner = trimmed(field);
    add_field(inner.empty() ? field.substr(0, 0) : inner);
    begin = end + 1;
  }
}

std::string_view DelimitedRows::quoted(std::string_view from) const {
  for (std::size_t i = 1; i < from.size(); ++i) {
    if (from[i] != '"') continue;
    if (i + 1 == from.size() || from[i + 1] != '"') return from.substr(1, i - 1);
    ++i;
  }
  throw source_.error(from, "a quote that is never closed", "the field runs to the end of its line",
                      "close it");
}

NumberStyle style_of(DelimitedRows rows, const std::vector<std::optional<std::size_t>>& columns) {
  const bool comma = rows.separator() == ',';
  NumberStyle style(comma);
  const std::string_view text = rows.source().text();
  if (text.find(comma ? '"' : ',') == std::string_view::npos) return style;
  do {
    for (const auto& column : columns)
      if (column && *column < rows.fields().size()) style.see(rows.fields()[*column]);
  } while (rows.next());
  return style;
}

double number_in(const SourceText& source, const NumberStyle& style, std::string_view field,
                 std::string_view column) {
  if (const auto number = style.real(field)) return *number;
  const std::string problem = fmt::format("{} = '{}'", column, excerpt(field));
  if (style.two_ways(field, false))
    throw source.error(field, problem, "its mark may part thousands or decimals",
                       "write it without marks of thousands, and with a decimal point");
  throw source.error(field, problem, "not a finite number that a double holds", "write it like 0.23 or 1e-3");
}

double number_or_none(const SourceText& source, const NumberStyle& style, std::string_view field,
                      std::string_view column) {
  if (is_missing(field)) return std::numeric_limits<double>::quiet_NaN();
  return number_in(source, style, field, column);
}

}  // namespace ramify
