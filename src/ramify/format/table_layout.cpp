#include "ramify/format/table_layout.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

using Header = std::vector<std::string_view>;

std::string_view expected_columns(TableKind kind) {
  switch (kind) {
    case TableKind::edges:
      return "id,parent or parent,child";
    case TableKind::qsm:
      return "id, parent, radius and length";
    case TableKind::flowlines:
      return "id,toid or comid,tocomid or hydroseq,dnhydroseq or fromnode,tonode";
  }
  return {};
}

auto finder_of(TableKind kind) {
  switch (kind) {
    case TableKind::edges:
      return &edge_columns;
    case TableKind::qsm:
      return &qsm_columns;
    case TableKind::flowlines:
      break;
  }
  return &flowline_columns;
}

/// TreeQSM writes two points, start and axis, below one name each.
Header with_points_spread(const Header& header) {
  Header spread;
  for (const std::string_view column : header) {
    const std::string name = plain_column(column);
    const bool is_point = name == "startpoint" || name == "axisdirection";
    spread.insert(spread.end(), is_point ? 3 : 1, column);
  }
  return spread;
}

/// Rows parent, child[, length[, radius]] without a header.
TableColumns plain_edges(const DelimitedRows& rows) {
  const std::size_t fields = rows.fields().size();
  if (fields < 2 || fields > 4)
    throw rows.source().error(rows.fields().front(), fmt::format("a row of {} field(s)", fields),
                              "a list of edges without a header has parent, child[, length[, radius]]",
                              "name the columns in a first line");
  TableColumns columns;
  columns.parent = 0;
  columns.id = 1;
  columns.pairs = true;
  if (fields > 2) columns.length = 2;
  if (fields > 3) columns.radius = 3;
  return columns;
}

TableColumns treeqsm_columns() {
  TableColumns columns;
  columns.radius = 0;
  columns.length = 1;
  columns.parent = 8;
  return columns;
}

}  // namespace

std::optional<TableKind> announced_table(const Header& header) {
  for (const TableKind kind : {TableKind::flowlines, TableKind::qsm, TableKind::edges})
    if (finder_of(kind)(header)) return kind;
  return std::nullopt;
}

bool is_treeqsm(const Header& fields) {
  if (fields.size() != 15 && fields.size() != 17) return false;
  const NumberStyle style(false);
  return std::ranges::all_of(fields, [&](auto field) { return style.real(field).has_value(); }) &&
         whole_number(fields[8]) && whole_number(fields[9]) && whole_number(fields[10]);
}

namespace detail {

void remark_columns(const std::vector<std::string_view>& names, Remarks& remarks) {
  for (const std::string_view name : names)
    if (!name.empty()) remarks.ignore_named("column", name);
  remarks.ignore("column", "without a name", static_cast<std::size_t>(std::ranges::count(names, "")));
}

void remark_ignored(const TableLayout& layout, Remarks& remarks) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < layout.header.size(); ++i)
    if (!layout.columns.uses(i)) names.push_back(layout.header[i]);
  remark_columns(names, remarks);
}

bool has_row_names(DelimitedRows rows, std::size_t columns) {
  do {
    if (rows.fields().size() != columns + 1) return false;
    if (!rows.fields().back().empty()) return true;
  } while (rows.next());
  return false;
}

void require_fields(const DelimitedRows& rows, std::size_t expected) {
  const auto& fields = rows.fields();
  const bool rest_is_empty =
      fields.size() > expected && std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(expected),
                                              fields.end(), [](auto field) { return field.empty(); });
  if (fields.size() == expected || rest_is_empty) return;
  const std::string_view odd = fields[std::min(fields.size() - 1, expected)];
  throw rows.source().error(odd, fmt::format("a row of {} field(s)", fields.size()),
                            fmt::format("the first row has {}", expected), "give every row as many fields");
}

TableLayout layout_below_header(DelimitedRows& rows, std::optional<TableColumns> (*find)(const Header&)) {
  Header header = rows.fields();
  if (!rows.next())
    throw rows.source().error(rows.source().text().size(), "no rows", "a tree has a node at least",
                              "add rows below the header");
  if (rows.fields().size() == header.size() + 4) header = with_points_spread(header);
  if (has_row_names(rows, header.size())) header.insert(header.begin(), std::string_view());
  const auto columns = find(header);
  return {*columns, header};
}

TableLayout read_table_layout(DelimitedRows& rows, TableKind kind) {
  const auto find = finder_of(kind);
  if (find(rows.fields())) return layout_below_header(rows, find);
  const Header comment = rows.commented_header();
  if (comment.size() == rows.fields().size())
    if (const auto columns = find(comment)) return {*columns, comment};
  if (kind == TableKind::edges) return {plain_edges(rows), Header(rows.fields().size())};
  if (kind == TableKind::qsm && is_treeqsm(rows.fields()))
    return {treeqsm_columns(), Header(rows.fields().size())};
  throw rows.source().error(rows.fields().front(), "columns are missing",
                            fmt::format("such a table has {}", expected_columns(kind)),
                            "name them in the first line");
}

}  // namespace detail
}  // namespace ramify
