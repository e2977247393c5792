#include "ramify/format/delimited_rows.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr std::string_view blanks = " \t\v\f";

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

char separator_of(std::string_view line) {
  for (const char c : {',', '\t', ';'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

}  // namespace

bool DelimitedRows::next() {
  while (lines_.next()) {
    const std::string_view line = lines_.line();
    const auto first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos || line[first] == '#') continue;
    if (separator_ == 0) separator_ = separator_of(line);
    fields_.clear();
    if (separator_ == ' ') {
      cut_at_spaces(line);
    } else {
      cut(line);
    }
    return true;
  }
  return false;
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
    const std::size_t first = line.find_first_not_of(" \t", begin);
    if (first < line.size() && line[first] == '"' && separator_ != ' ') {
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

double number_in(const SourceText& source, std::string_view field, std::string_view column) {
  if (const auto number = parse_real(field)) return *number;
  throw source.error(field, fmt::format("{} = '{}'", column, excerpt(field)),
                     "not a finite number that a double holds", "write it like 0.23 or 1e-3");
}

double number_or_none(const SourceText& source, std::string_view field, std::string_view column) {
  if (field.empty() || field == "NA" || field == "NaN" || field == "nan")
    return std::numeric_limits<double>::quiet_NaN();
  return number_in(source, field, column);
}

}  // namespace ramify
