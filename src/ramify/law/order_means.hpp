#pragma once

#include <vector>

#include "ramify/law/bounded_law.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// E N_k(n) and E M_k(n): nodes and streams of order k, leaf order 0 (B8, B9).
///
/// Both counts of a tree are those of its children, plus one where the root has order k, or begins a stream
/// of order k (both children of order k-1); N_0 = M_0 = n+1. Relative error below 1e-13 where
/// a mean is above 1e-20, beside that of the split rows. Memory O(n log n),
/// time O(n^2 log n).
class OrderMeans {
 public:
  explicit OrderMeans(Size largest_n);

  Size sizes() const { return strahler_.sizes(); }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  /// E N_k, k = 0..K, K = floor(log2(largest_n + 1)).
  std::vector<double> nodes(Size n) const { return at_size(nodes_, n); }

  /// E M_k, k = 0..K.
  std::vector<double> streams(Size n) const { return at_size(streams_, n); }

  /// E of one count; 0 for an order above K.
  double mean(Size n, OrderCount count) const;

  const BoundedLaw& strahler() const { return strahler_; }

 private:
  static std::vector<double> at_size(const std::vector<SizeSeries>& counts, Size n);

  BoundedLaw strahler_;
  std::vector<SizeSeries> nodes_, streams_;
};

}  // namespace ramify
