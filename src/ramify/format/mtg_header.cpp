#include "ramify/format/mtg_header.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <string>

#include <fmt/format.h>

#include "ramify/format/table_columns.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify::detail {
namespace {

bool is_blank(const std::vector<std::string_view>& fields) {
  for (const std::string_view field : fields)
    if (!field.empty()) return false;
  return true;
}

/// "CLASSES :" begins the section of that name.
bool begins_section(const std::vector<std::string_view>& fields, std::string_view name) {
  const std::string_view first = fields.front();
  const auto colon = first.find(':');
  return trimmed(first.substr(0, colon)) == name &&
         (colon != std::string_view::npos || (fields.size() > 1 && fields[1].starts_with(':')));
}

/// White space of any kind parts the fields of the header.
std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  constexpr std::string_view blanks = " \t";
  for (std::size_t begin = line.find_first_not_of(blanks); begin < line.size();) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    found.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return found;
}

void read_class(const SourceText& source, std::string_view line, MtgHeader& header) {
  const auto fields = words(line.substr(0, line.find('#')));
  if (fields.size() < 2 || fields[0] == "SYMBOL") return;
  unsigned scale = 0;
  const auto [end, status] = std::from_chars(fields[1].data(), fields[1].data() + fields[1].size(), scale);
  if (status != std::errc() || end != fields[1].data() + fields[1].size() || scale > 1000)
    throw source.error(fields[1], fmt::format("scale '{}'", excerpt(fields[1])),
                       "scales are whole numbers, 1000 at most", "correct the class");
  header.scales[fields[0]] = scale;
}

void read_column_names(const std::vector<std::string_view>& fields, MtgHeader& header) {
  std::vector<std::string> names(fields.size());
  header.code_columns = SIZE_MAX;
  for (std::size_t i = fields.size(); i-- > 1;) {
    names[i] = plain_column(fields[i]);
    if (fields[i].empty()) continue;
    header.code_columns = i;
    header.columns = std::max(header.columns, i + 1);
  }
  const auto find = [&](std::initializer_list<std::string_view> known) -> std::optional<std::size_t> {
    for (const std::string_view name : known)
      if (const auto found = std::ranges::find(names, name); found != names.end())
        return static_cast<std::size_t>(found - names.begin());
    return std::nullopt;
  };
  header.length = find_column(names, ColumnRole::length);
  header.radius = find_column(names, ColumnRole::radius);
  if (!header.radius) header.diameter = find_column(names, ColumnRole::diameter);
  if (!header.radius && !header.diameter) header.diameter = find({"topdia", "topdiameter"});
  header.x = find({"xx", "x"});
  header.y = find({"yy", "y"});
  header.z = find({"zz", "z"});
  const std::array used{header.length, header.radius, header.diameter, header.x, header.y, header.z};
  for (std::size_t i = 1; i < fields.size(); ++i)
    if (!fields[i].empty() && std::ranges::find(used, std::optional(i)) == used.end())
      header.ignored.push_back(fields[i]);
}

}  // namespace

std::vector<std::string_view> mtg_fields(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    const std::string_view whole = line.substr(begin, end - begin);
    const std::string_view field = trimmed(whole.substr(0, whole.find('#')));
    fields.push_back(field.empty() ? line.substr(begin, 0) : field);
    begin = end + 1;
  }
  return fields;
}

MtgHeader read_mtg_header(const SourceText& source, LineCursor& lines) {
  MtgHeader header;
  bool in_classes = false, in_code = false;
  while (lines.next()) {
    const auto fields = mtg_fields(lines.line());
    if (is_blank(fields)) continue;
    if (begins_section(fields, "CODE") && lines.line().find("FORM-A") == std::string_view::npos)
      throw source.error(fields.front(), "a code other than FORM-A", "that alone is read",
                         "save the MTG with CODE: FORM-A");
    if (in_code) {
      if (fields.front() != "ENTITY-CODE" && fields.front() != "TOPO")
        throw source.error(lines.line(), "no line of column names",
                           "the section MTG begins with ENTITY-CODE and the names of the features",
                           "restore it");
      read_column_names(fields, header);
      if (header.scales.empty())
        throw source.error(lines.line(), "no classes", "the section CLASSES gives every symbol its scale",
                           "restore it");
      return header;
    }
    in_code = begins_section(fields, "MTG");
    const bool begins_other = in_code || begins_section(fields, "DESCRIPTION") ||
                              begins_section(fields, "FEATURES") || begins_section(fields, "CODE");
    if (in_classes && !begins_other) read_class(source, lines.line(), header);
    in_classes = (in_classes && !begins_other) || begins_section(fields, "CLASSES");
  }
  throw source.error(source.text().size(), "no entities", "the section MTG holds them",
                     "restore what was cut off");
}

}  // namespace ramify::detail
