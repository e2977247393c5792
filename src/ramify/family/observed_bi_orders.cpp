#include "ramify/family/observed_bi_orders.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/family/require_binary.hpp"
#include "ramify/model/ramification_matrix.hpp"
#include "ramify/statistic/bi_orders.hpp"
#include "ramify/text/header_fields.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {

ObservedBiOrders::ObservedBiOrders(const Tree& tree, std::string_view where) {
  for (const std::uint32_t children : tree.arities())
    if (children != 0) require_binary(children, where);
  BiOrders fold;
  const std::size_t order = measure(tree, fold);
  for (std::size_t k = 1; k <= order; ++k) {
    auto& row = rows_.emplace_back();
    for (std::size_t j = 0; j < k; ++j) row.push_back(static_cast<double>(fold.counts().joined(k, j)));
    row.push_back(static_cast<double>(fold.counts().joined(k - 1, k - 1)));
  }
  tree_orders_.push_back(order);
}

ObservedBiOrders ObservedBiOrders::of_table(const CsvData& table) {
  ObservedBiOrders observed;
  observed.rows_ = read_bi_order_counts(table);
  const std::size_t top = observed.largest_order();
  constexpr double most_trees = 1e6;
  for (std::size_t k = top; k >= 1; --k) {
    double go_on = k < top ? 2 * observed.streams(k + 1) : 0;
    for (std::size_t above = k + 1; above <= top; ++above) go_on += observed.count(above, k);
    if (observed.streams(k) == 0)
      throw Error(fmt::format("{}: no streams of the order {} above the tips", table.name(), k),
                  fmt::format("there are streams of order {}, or sides of order {}", top, k),
                  "add the row whose side is its order: the streams that begin");
    const double roots = observed.streams(k) - go_on;
    if (roots > most_trees)
      throw Error(
          fmt::format("{}: {} streams of the order {} above the tips join nothing", table.name(), roots, k),
          fmt::format("they are roots of trees, of which a table may have {}", most_trees),
          "add the rows that say where they end");
    if (roots < 0)
      throw Error(
          fmt::format("{}: {} streams of the order {} above the tips", table.name(), observed.streams(k), k),
          fmt::format("{} of them are counted where they end, on the side of a higher order or two at "
                      "the start of one",
                      go_on),
          "count every stream once where it begins (side = order), once where it ends");
    observed.tree_orders_.insert(observed.tree_orders_.end(), static_cast<std::size_t>(roots), k);
  }
  return observed;
}

void ObservedBiOrders::add(const ObservedBiOrders& others) {
  while (rows_.size() < others.rows_.size()) rows_.emplace_back(rows_.size() + 2, 0.0);
  for (std::size_t k = 0; k < others.rows_.size(); ++k)
    std::ranges::transform(rows_[k], others.rows_[k], rows_[k].begin(), std::plus<>());
  tree_orders_.insert(tree_orders_.end(), others.tree_orders_.begin(), others.tree_orders_.end());
}

double ObservedBiOrders::nodes(std::size_t k) const {
  return std::accumulate(rows_[k - 1].begin(), rows_[k - 1].end(), 0.0);
}

double ObservedBiOrders::all_nodes() const {
  double sum = 0;
  for (std::size_t k = 1; k <= largest_order(); ++k) sum += nodes(k);
  return sum;
}

double ObservedBiOrders::side_branches(std::size_t i) const {
  double sum = 0;
  for (std::size_t k = i; k <= largest_order(); ++k) sum += count(k, k - i);
  return sum;
}

bool is_bi_order_table(std::string_view text) {
  const auto header = header_fields(text);
  return std::ranges::all_of(std::array{"order", "side", "count"}, [&header](std::string_view column) {
    return std::ranges::find(header, column) != header.end();
  });
}

}  // namespace ramify
