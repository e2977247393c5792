#pragma once

#include <map>
#include <utility>

#include "ramify/law/bounded_law.hpp"
#include "ramify/law/size_series.hpp"
#include "ramify/law/split_row.hpp"

namespace ramify {

/// Expected numbers of nodes whose children have the orders (high, low), leaf order 0, of every size: those
/// of the children, and one where the root is such a node. Extended size by size, as the laws of law/ are.
class BiOrderMeans {
 public:
  /// @param highest  the largest order of a child
  BiOrderMeans(std::size_t highest, Size largest_n);

  Size sizes() const { return strahler_.sizes(); }
  void extend(const SplitRow& row);

  /// E of the nodes that join high >= low.
  double joined(Size n, std::size_t high, std::size_t low) const { return joined_.at({high, low})[n]; }

  /// P(k, low) of the ramification matrix: of the nodes of order k those of bi-order (k, low), low < k, or,
  /// at low = k, (k-1, k-1). Nodes of all trees of size n together.
  double ramification(Size n, std::size_t k, std::size_t low) const;

  /// Tokunaga's T: side branches of order low for each stream of order high > low.
  double tokunaga(Size n, std::size_t high, std::size_t low) const {
    return joined(n, high, low) / joined(n, high - 1, high - 1);
  }

 private:
  BoundedLaw strahler_;
  std::map<std::pair<std::size_t, std::size_t>, SizeSeries> joined_;
};

}  // namespace ramify
