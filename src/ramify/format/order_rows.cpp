#include "ramify/format/order_rows.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/table_columns.hpp"
#include "ramify/format/table_layout.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify::detail {
namespace {

using Column = std::optional<std::size_t>;

struct OrderColumns {
  Column tree, order, count, leaf_order, length, radius, diameter, area;

  bool uses(std::size_t column) const {
    const std::array all{tree, order, count, leaf_order, length, radius, diameter, area};
    return std::ranges::find(all, Column(column)) != all.end();
  }
};

OrderColumns columns_of(const DelimitedRows& rows) {
  std::vector<std::string> names;
  for (const std::string_view column : rows.fields()) names.push_back(plain_column(column));
  const auto find = [&](ColumnRole role) { return find_column(names, role); };
  OrderColumns columns{find(ColumnRole::tree),       find(ColumnRole::order),  find(ColumnRole::count),
                       find(ColumnRole::leaf_order), find(ColumnRole::length), find(ColumnRole::radius),
                       find(ColumnRole::diameter),   find(ColumnRole::area)};
  if (!columns.order || !columns.count)
    throw rows.source().error(rows.fields().front(),
                              fmt::format("no column of {}", columns.order ? "counts" : "orders"),
                              "such a table has order and count", "name them so in the first line");
  return columns;
}

bool is_total(std::string_view order) {
  constexpr std::array<std::string_view, 7> words{"total", "totals",  "sum",  "all",
                                                  "sums",  "overall", "whole"};
  const std::string name = plain_column(order);
  return std::ranges::find(words, name) != words.end();
}

class OrderReader {
 public:
  OrderReader(const SourceText& source, const OrderColumns& columns, NumberStyle style)
      : source_(source), columns_(columns), style_(style) {}

  void add(const std::vector<std::string_view>& fields) {
    const std::string_view order = fields[*columns_.order], count = fields[*columns_.count];
    if (std::ranges::all_of(fields, [](auto field) { return field.empty(); })) return;
    const std::string_view tree = columns_.tree ? fields[*columns_.tree] : std::string_view();
    auto found = std::ranges::find(read_.trees, tree, [](const auto& entry) { return entry.first; });
    if (found == read_.trees.end()) found = read_.trees.insert(found, {tree, {}});
    if (is_total(order)) {
      read_.remarks.ignore("row", "of totals");
      if (const auto total = style_.count(count))
        totals_.emplace_back(static_cast<std::size_t>(found - read_.trees.begin()), *total);
      return;
    }
    OrderRow row{whole(order, "order"),
                 whole(count, "count"),
                 {},
                 positive(columns_.diameter, fields, "diameter"),
                 positive(columns_.length, fields, "length"),
                 positive(columns_.area, fields, "area"),
                 order,
                 count,
                 {}};
    const double radius = positive(columns_.radius, fields, "radius");
    if (columns_.radius) row.diameter = 2 * radius;
    if (columns_.leaf_order && !is_missing(fields[*columns_.leaf_order])) {
      row.leaf_order_field = fields[*columns_.leaf_order];
      row.leaf_order = whole(row.leaf_order_field, "leaf_order");
    }
    found->second.push_back(row);
  }

  /// What was read, with totals compared.
  OrderRows take() {
    for (const auto& [tree, total] : totals_) {
      std::uint64_t sum = 0;
      for (const OrderRow& row : read_.trees[tree].second) sum += row.count;
      if (total != sum)
        read_.remarks.doubt(fmt::format("the total is {}, the counts of the orders sum to {}", total, sum));
    }
    std::erase_if(read_.trees, [](const auto& tree) { return tree.second.empty(); });
    return std::move(read_);
  }

 private:
  std::uint64_t whole(std::string_view field, std::string_view column) const {
    if (const auto number = style_.count(field)) return *number;
    const std::string problem = fmt::format("{} = '{}'", column, excerpt(field));
    if (style_.two_ways(field, true))
      throw source_.error(field, problem, "its mark may part thousands or decimals",
                          "write it without marks of thousands");
    if (is_missing(field)) throw source_.error(field, problem, "a whole number is needed here", "fill it in");
    throw source_.error(field, problem, "not a whole number from 0", "write it like 579, 1_000_000 or 1e6");
  }

  double positive(Column column, const std::vector<std::string_view>& fields, std::string_view name) const {
    if (!column) return std::numeric_limits<double>::quiet_NaN();
    const double value = number_or_none(source_, style_, fields[*column], name);
    if (value <= 0)
      throw source_.error(fields[*column], fmt::format("{} {}", name, value),
                          fmt::format("the {} of streams is positive", name),
                          "correct it, or leave the field empty");
    return value;
  }

  SourceText source_;
  OrderColumns columns_;
  NumberStyle style_;
  OrderRows read_;
  std::vector<std::pair<std::size_t, std::uint64_t>> totals_;  // of the trees by place
};

}  // namespace

OrderRows read_order_rows(const SourceText& source) {
  DelimitedRows rows(source);
  if (!rows.next())
    throw source.error(source.text().size(), "no header", "a table starts with a line that names its columns",
                       "add one, such as order,count");
  OrderColumns columns = columns_of(rows);
  std::vector<std::string_view> ignored;
  for (std::size_t i = 0; i < rows.fields().size(); ++i)
    if (!columns.uses(i)) ignored.push_back(rows.fields()[i]);
  const std::size_t width = rows.fields().size();
  if (!rows.next())
    throw source.error(source.text().size(), "no rows", "a bifurcation ratio needs two orders", "add rows");
  const bool row_names = has_row_names(rows, width);
  if (row_names)
    for (Column* column : {&columns.tree, &columns.order, &columns.count, &columns.leaf_order,
                           &columns.length, &columns.radius, &columns.diameter, &columns.area})
      if (*column) ++**column;
  OrderReader reader(source, columns,
                     style_of(rows, {columns.order, columns.count, columns.length, columns.radius,
                                     columns.diameter, columns.area}));
  do {
    require_fields(rows, row_names ? width + 1 : width);
    reader.add(rows.fields());
  } while (rows.next());
  OrderRows read = reader.take();
  remark_columns(ignored, read.remarks);
  return read;
}

}  // namespace ramify::detail
