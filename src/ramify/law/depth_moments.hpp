#pragma once

#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/split_rows.hpp"

namespace ramify {

/// Mean and variance of the depth D_n of the last node for every size 0..n: D_0 = 0, D_1 = 1, and from size n
/// >= 2 one more than that of a child of size i, taken with probability i/(n-1) (B23).
///
/// The variance is summed as E Var + Var E over the splits: nothing is subtracted. Relative error about
/// 1e-13. Memory O(n), time O(n^2).
class DepthMoments {
 public:
  /// Only size 0 is known at first.
  DepthMoments() : moments_{{0, 0}} {}

  Size sizes() const { return moments_.size(); }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  Moments moments(Size n) const { return moments_[n]; }

 private:
  std::vector<Moments> moments_;
};

}  // namespace ramify
