#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/size_series.hpp"
#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// The exact law of a statistic with values 0..floor(log2(n+1)), for every size 0..n: the fold over
/// distributions.
///
/// Sums of products of probabilities: nothing is subtracted. Rows are rescaled to sum 1, so rounding does not
/// grow with n; probabilities below 1e-40 are taken for 0, so that those above 1e-20 keep a relative accuracy
/// of 1e-13, as long as the rows of the splits have it.
/// Memory O(n log n). Time O(n^2 w), w the number of values that have a probability at one size: 3 or 4; a
/// vectorised half nanosecond a step.
class BoundedLaw {
 public:
  /// Room for the sizes 0..largest_n; at first only size 0 is known, with V = 0.
  BoundedLaw(BoundedJoin join, Size largest_n);

  /// The sizes 0..sizes()-1 are known.
  Size sizes() const { return sizes_; }

  /// Adds the size row.n == sizes() <= largest_n.
  void extend(const SplitRow& row);

  /// P(V = k), k = 0..K, K = floor(log2(largest_n + 1)), of a tree of size n < sizes(); 0 for one below
  /// 1e-30.
  std::vector<double> pmf(Size n) const;

  /// The value of pmf(n)'s first entry.
  static Size lowest(Size) { return 0; }

  /// P(V = k) of size n < sizes(); 0 outside 0..K.
  double at(Size n, std::ptrdiff_t k) const;

  /// One form of the value k = -1..K+1, of every size 0..sizes()-1.
  const SizeSeries& all_sizes(LawForm form, std::ptrdiff_t k) const { return series(form, k); }

  Moments moments(Size n) const { return moments_of(pmf(n), 0); }

 private:
  const SizeSeries& series(LawForm form, std::ptrdiff_t k) const {
    return series_[static_cast<std::size_t>(form)][static_cast<std::size_t>(k + 1)];
  }
  SizeSeries& series(LawForm form, std::ptrdiff_t k) {
    return series_[static_cast<std::size_t>(form)][static_cast<std::size_t>(k + 1)];
  }
  void append(const std::vector<double>& weights);

  JoinRule rule_;
  std::ptrdiff_t top_;
  Size sizes_ = 0;
  std::array<std::vector<SizeSeries>, 3> series_;  ///< of value k at index k+1
};

}  // namespace ramify
