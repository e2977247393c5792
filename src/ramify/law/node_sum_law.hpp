#pragma once

#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/size_series.hpp"
#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// Exact mean and variance of a sum over the nodes of a tree of a toll c on each one's split, for every size
/// 0..n (B23).
///
/// Y(n) = w (Y(L) + Y(R)) + c(L+1, R+1), Y(0) = 0, w = 1, or 1/2 where it is averaged; the children
/// independent given their sizes, so E Y is the mean over the splits of the right side, and Var Y that of Var
/// Y(L) + Var Y(R) plus the variance over the splits of E Y(L) + E Y(R) + c. Sums of positive terms: relative
/// error about 1e-13. Memory O(n), time O(n^2), for rows of n entries.
class NodeSumLaw {
 public:
  explicit NodeSumLaw(NodeSum sum);

  Size sizes() const { return sizes_; }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  Moments moments(Size n) const { return {mean_[n], variance_[n]}; }

 private:
  Toll toll_;
  double child_weight_;
  Size sizes_ = 1;
  SizeSeries mean_, variance_;
  std::vector<double> given_;  ///< E Y given the split, of the row that is added
};

}  // namespace ramify
