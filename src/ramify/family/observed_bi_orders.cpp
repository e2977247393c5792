#include "ramify/family/observed_bi_orders.hpp"

#include <algorithm>
#include <numeric>

#include "ramify/family/require_binary.hpp"
#include "ramify/statistic/bi_orders.hpp"
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

}  // namespace ramify
