#include "ramify/format/order_counts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/order_rows.hpp"
#include "ramify/format/table_columns.hpp"
#include "ramify/format/tree_table.hpp"
#include "ramify/text/line_cursor.hpp"

namespace ramify {
namespace {

using detail::OrderRow;
using detail::OrderRows;

std::uint64_t leaf_order_of(const SourceText& source, const std::vector<OrderRow>& rows) {
  std::optional<std::uint64_t> leaf_order;
  for (const OrderRow& row : rows) {
    if (!row.leaf_order) continue;
    if (*row.leaf_order > 1 || (leaf_order && *leaf_order != *row.leaf_order)) {
      throw source.error(row.leaf_order_field, fmt::format("leaf_order {}", *row.leaf_order),
                         "the order of the outermost branches is 0 or 1, the same in the whole table",
                         "correct it");
    }
    leaf_order = row.leaf_order;
  }
  return leaf_order.value_or(1);
}

std::vector<std::uint64_t> counts_of(const SourceText& source, const std::vector<OrderRow>& rows,
                                     std::uint64_t leaf_order) {
  std::vector<std::uint64_t> counts;
  for (const OrderRow& row : rows) {
    const std::uint64_t expected = leaf_order + counts.size();
    if (row.order != expected)
      throw source.error(row.order_field, fmt::format("order {}", row.order),
                         fmt::format("order {} comes here: from the leaf order up, each once", expected),
                         "add the row that is missing, or set leaf_order");
    if (row.count == 0 || (!counts.empty() && row.count >= counts.back()))
      throw source.error(
          row.count_field, fmt::format("count {}", row.count),
          row.count == 0 ? "an order that is there has a stream" : "streams become fewer with every order",
          "give the number of streams of each order");
    counts.push_back(row.count);
  }
  if (counts.size() < 2)
    throw source.error(rows.front().order_field, fmt::format("order {} alone", rows.front().order),
                       "a bifurcation ratio needs two orders", "add rows");
  return counts;
}

/// Counts of streams obey N_k >= 2 N_(k+1) and end with 1; sums near 2 N_1 - 1 are those of links.
std::vector<std::string> warnings_of(const SourceText& source, const std::vector<OrderRow>& rows,
                                     const OrderCounts& orders) {
  std::vector<std::string> warnings;
  const auto& counts = orders.counts;
  double sum = 0;
  for (const std::uint64_t count : counts) sum += static_cast<double>(count);
  const double links = 2 * static_cast<double>(counts.front()) - 1;
  if (std::abs(sum - links) <= std::max(1.0, 0.02 * links)) {
    warnings.push_back(fmt::format(
        "{}: the counts sum to {}, about 2*{}-1: these may be links, nodes or Horsfield orders, not streams",
        orders.name, sum, counts.front()));
  }
  for (std::size_t k = 0; k + 1 < counts.size(); ++k) {
    if (can_follow(counts[k], counts[k + 1])) continue;
    SourceLocation place = source.at(source.offset(rows[k + 1].count_field));
    place.column = 0;
    warnings.push_back(
        fmt::format("{}{} after {} cannot be a count of streams: two of one order meet for each of the next",
                    to_prefix(place), counts[k + 1], counts[k]));
  }
  if (counts.back() != 1) {
    warnings.push_back(
        fmt::format("{}: {} streams of the highest order: more than one tree, or one cut short", orders.name,
                    counts.back()));
  }
  return warnings;
}

/// The first order that has too many streams for a binary tree.
std::optional<Error> contradiction_of(const SourceText& source, const std::vector<OrderRow>& rows,
                                      const std::vector<std::uint64_t>& counts) {
  for (std::size_t k = 0; k + 1 < counts.size(); ++k)
    if (!can_follow(counts[k], counts[k + 1]))
      return source.error(
          rows[k + 1].count_field, fmt::format("count {} after {}", counts[k + 1], counts[k]),
          "two streams of one order meet for each of the next, so counts fall by half or more",
          "count streams, not links, nodes or Horsfield orders");
  return std::nullopt;
}

OrderCounts counts_of_tree(const SourceText& source, const std::string& name, std::vector<OrderRow> rows) {
  std::ranges::stable_sort(rows, {}, &OrderRow::order);
  OrderCounts orders{name, leaf_order_of(source, rows), {}, {}, {}, {}, {}, {}};
  orders.counts = counts_of(source, rows, orders.leaf_order);
  for (const OrderRow& row : rows) {
    orders.diameters.push_back(row.diameter);
    orders.lengths.push_back(row.length);
    orders.areas.push_back(row.area);
  }
  for (auto* means : {&orders.diameters, &orders.lengths, &orders.areas})
    if (std::ranges::all_of(*means, [](double mean) { return std::isnan(mean); })) means->clear();
  orders.warnings = warnings_of(source, rows, orders);
  orders.contradiction = contradiction_of(source, rows, orders.counts);
  return orders;
}

/// Quotes come in pairs, and what follows a second one parts fields: cutting the line cannot fail.
bool is_well_quoted(std::string_view line) {
  bool open = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '"') continue;
    open = !open;
    const bool ends =
        i + 1 == line.size() || std::string_view(",;\t ").find(line[i + 1]) != std::string_view::npos;
    if (!open && !ends) return false;
  }
  return !open;
}

}  // namespace

std::vector<OrderCounts> read_order_counts(SourceText source) {
  const OrderRows table = detail::read_order_rows(source);
  std::vector<OrderCounts> all;
  for (const auto& [tree, rows] : table.trees) {
    const std::string name =
        tree.empty() ? std::string(source.name()) : fmt::format("{}:{}", source.name(), tree);
    all.push_back(counts_of_tree(source, name, rows));
  }
  if (all.empty())
    throw source.error(source.text().size(), "no rows", "a bifurcation ratio needs two orders", "add rows");
  for (const std::string& line : table.remarks.lines(source.name())) all.front().warnings.push_back(line);
  return all;
}

bool is_order_table(std::string_view text) {
  // Binary files and long lines have no header worth cutting into fields.
  constexpr std::size_t longest_header = 1000;
  LineCursor lines(text);
  do {
    if (!lines.next()) return false;
  } while (lines.line().empty() || lines.line().starts_with('#'));
  if (lines.line().size() > longest_header || !is_well_quoted(lines.line())) return false;
  DelimitedRows rows(SourceText(text, ""));
  if (!rows.next() || announced_table(rows.fields())) return false;
  std::vector<std::string> header;
  for (const std::string_view column : rows.fields()) header.push_back(plain_column(column));
  return find_column(header, ColumnRole::order) && find_column(header, ColumnRole::count);
}

}  // namespace ramify
