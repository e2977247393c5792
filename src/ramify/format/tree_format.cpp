#include "ramify/format/tree_format.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/tree_table.hpp"
#include "ramify/text/line_cursor.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr std::array<std::string_view, 8> names{"newick", "swc",       "mtg",    "qsm",
                                                "edges",  "flowlines", "parens", "json"};

/// Numbers that do not fit a double are refused with their place, by a reader that knows what they are.
bool looks_like_number(std::string_view field) {
  return !field.empty() && field.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
}

/// Words of E and parentheses, or Newick, which has other characters or ends with a semicolon.
TreeFormat format_of_parentheses(std::string_view text) {
  const std::size_t other = text.find_first_of(",:;['");
  return other == std::string_view::npos ? TreeFormat::parens : TreeFormat::newick;
}

std::optional<TreeFormat> format_of_table(const SourceText& source) {
  DelimitedRows rows(source);
  if (!rows.next()) return std::nullopt;
  TableKind kind{};
  if (announces_table(rows.fields(), kind)) {
    switch (kind) {
      case TableKind::flowlines:
        return TreeFormat::flowlines;
      case TableKind::qsm:
        return TreeFormat::qsm;
      case TableKind::edges:
        return TreeFormat::edges;
    }
  }
  const auto& fields = rows.fields();
  constexpr std::size_t swc_fields = 7;
  if (fields.size() >= swc_fields && looks_like_number(fields[0]) && looks_like_number(fields[6]))
    return TreeFormat::swc;
  if (fields.size() < 2 || fields.size() > 4 || !std::ranges::all_of(fields, looks_like_number))
    return std::nullopt;
  return TreeFormat::edges;
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
  if (begin.starts_with("#NEXUS") || begin.starts_with("#nexus"))
    throw source.error(first, "a NEXUS file", "it is not read", "export its trees as Newick");
  if (begin.front() == '{') return TreeFormat::json;
  if (begin.front() == '(') return format_of_parentheses(begin);
  if (begin.front() == '[' || begin.front() == '\'') return TreeFormat::newick;
  LineCursor lines(begin);
  lines.next();
  const std::string_view first_line = trimmed(lines.line());
  if (first_line == "E") return TreeFormat::parens;
  if (begin.starts_with("CODE") && head.find("FORM-") != std::string_view::npos) return TreeFormat::mtg;
  if (const auto table = format_of_table(source)) return *table;
  if (first_line.ends_with(';')) return TreeFormat::newick;  // a leaf alone
  throw unknown_format(source, first, "its beginning is that of no known format");
}

}  // namespace ramify
