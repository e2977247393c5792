#include "ramify/format/tree_format.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/newick.hpp"
#include "ramify/format/nexus.hpp"
#include "ramify/format/point_rows.hpp"
#include "ramify/format/table_columns.hpp"
#include "ramify/format/tree_table.hpp"
#include "ramify/text/line_cursor.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr std::array<std::string_view, 9> names{"newick", "nexus",     "swc",    "mtg", "qsm",
                                                "edges",  "flowlines", "parens", "json"};

/// Numbers that do not fit a double are refused with their place, by a reader that knows what they are.
bool looks_like_number(std::string_view field) {
  return !field.empty() && field.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
}

/// Words of E and parentheses, or Newick, which has other characters or ends with a semicolon.
TreeFormat format_of_parentheses(std::string_view text) {
  LineCursor lines(text);
  lines.next();
  const std::size_t other = lines.line().find_first_not_of("E() \t");
  if (other != std::string_view::npos) return TreeFormat::newick;
  return text.find_first_of(",:;['") == std::string_view::npos ? TreeFormat::parens : TreeFormat::newick;
}

std::optional<TreeFormat> format_of_header(const std::vector<std::string_view>& header) {
  const auto kind = announced_table(header);
  if (kind == TableKind::flowlines) return TreeFormat::flowlines;
  if (point_columns(header)) return TreeFormat::swc;
  if (!kind) return std::nullopt;
  return *kind == TableKind::qsm ? TreeFormat::qsm : TreeFormat::edges;
}

std::optional<TreeFormat> format_of_table(const SourceText& source) {
  DelimitedRows rows(source);
  if (!rows.next()) return std::nullopt;
  if (const auto format = format_of_header(rows.fields())) return format;
  DelimitedRows points(source, DelimitedRows::Separator::points);
  points.next();
  if (detail::is_point_row(points.fields())) return TreeFormat::swc;
  if (is_treeqsm(rows.fields())) return TreeFormat::qsm;
  if (rows.commented_header().size() == rows.fields().size())
    if (const auto format = format_of_header(rows.commented_header())) return format;
  const auto& fields = rows.fields();
  if (fields.size() < 2 || fields.size() > 4 || !std::ranges::all_of(fields, looks_like_number))
    return std::nullopt;
  return TreeFormat::edges;
}

/// The text from its first line on that is no comment.
std::string_view below_comments(std::string_view text) {
  LineCursor lines(text);
  while (lines.next())
    if (const std::string_view line = trimmed(lines.line()); !line.empty() && !line.starts_with('#'))
      return text.substr(static_cast<std::size_t>(line.data() - text.data()));
  return {};
}

Error unknown_format(const SourceText& source, std::size_t place, std::string_view why) {
  return source.error(place, "not a file of trees", why,
                      fmt::format("name its format with --format: {}", fmt::join(names, ", ")));
}

}  // namespace

std::string_view name_of(TreeFormat format) {
  return names[static_cast<std::size_t>(format)];
}

std::vector<std::string> tree_format_names() {
  return {names.begin(), names.end()};
}

std::optional<TreeFormat> parse_tree_format(std::string_view name) {
  if (name == "auto") return std::nullopt;
  const auto found = std::ranges::find(names, name);
  if (found == names.end())
    throw Error(
        fmt::format("--format {}", name), "not a format of trees that is read",
        fmt::format("{}take auto, {}", did_you_mean(name, tree_format_names()), fmt::join(names, ", ")));
  return static_cast<TreeFormat>(found - names.begin());
}

TreeFormat detect_tree_format(const SourceText& source) {
  const std::string_view text = source.text();
  const std::string_view head = text.substr(0, 4096);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos)
    throw source.error(std::size_t{0}, "an empty file", "there is no tree in it", "give a file of trees");
  if (const std::size_t zero = head.find('\0'); zero != std::string_view::npos)
    throw source.error(zero, "a binary file", "trees are read from text, or text packed with gzip",
                       "export it as text");
  const std::string_view begin = text.substr(first);
  if (is_nexus(begin)) return TreeFormat::nexus;
  if (begin.front() == '{') return TreeFormat::json;
  if (begin.front() == '(') return format_of_parentheses(begin);
  if (begin.front() == '[' || begin.front() == '\'' || newick_count_line(begin) > 0)
    return TreeFormat::newick;
  LineCursor lines(begin);
  lines.next();
  const std::string_view first_line = trimmed(lines.line());
  if (first_line == "E") return TreeFormat::parens;
  if (below_comments(begin).starts_with("CODE") && head.find("FORM-") != std::string_view::npos)
    return TreeFormat::mtg;
  if (const auto table = format_of_table(source)) return *table;
  if (first_line.ends_with(';')) return TreeFormat::newick;  // a leaf alone
  throw unknown_format(source, first, "its beginning is that of no known format");
}

}  // namespace ramify
