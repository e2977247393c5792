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

/// A quantity c + d/n + O(1/n^2) at n -> infinity, by its values at n = largest, /2, /4: two of them give c,
/// and what the other two give instead is the bound.
struct Extrapolated {
  double value, bound;
};
template <class ValueAt>
Extrapolated at_infinity(Size largest, ValueAt value_at) {
  constexpr double rounding = 1e-10;
  const double last = value_at(largest), middle = value_at(largest / 2), first = value_at(largest / 4);
  const double value = 2 * last - middle;
  const double change = value - (2 * middle - first);
  return {value, (change < 0 ? -change : change) + rounding};
}

}  // namespace ramify
