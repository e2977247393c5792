#pragma once

#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/split_row.hpp"
#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// The exact law of the depth of a random node for every size 0..n: the size-biased walk (B23).
///
/// Of the last node: D_0 = 0, D_1 = 1, and from size n >= 2 one more than that of a child of size i, taken
/// with probability i/(n-1). Of a uniform external node: D_0 = 1, and one more than that of a child of size
/// i, taken with probability (i+1)/(n+1). Sums of positive terms, scaled to sum 1; probabilities below 1e-20
/// at either end are not stored. Memory O(n w), time O(n^2 w), w the number of depths stored for one size:
/// about 40 for bst at n = 1000.
class DepthLaw {
 public:
  /// Only size 0 is known at first.
  explicit DepthLaw(WeightedWalk walk)
      : weight_of_none_(walk.weight_of_none), laws_{{weight_of_none_, {1.0}}} {}

  Size sizes() const { return laws_.size(); }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  /// P(D_n = d), d = lowest(n) + 0, 1, ...
  const std::vector<double>& pmf(Size n) const { return laws_[n].probabilities; }

  /// The smallest depth that pmf(n) holds.
  Size lowest(Size n) const { return laws_[n].first; }

  Moments moments(Size n) const { return moments_of(pmf(n), static_cast<double>(lowest(n))); }

 private:
  struct Law {
    Size first;
    std::vector<double> probabilities;
  };
  Size weight_of_none_;  ///< a child of size i is taken with probability proportional to i + this
  std::vector<Law> laws_;
};

}  // namespace ramify
