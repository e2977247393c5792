#pragma once

#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/size_series.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/law/tail_series.hpp"

namespace ramify {

/// The exact law of the height H_n for every size 0..n: nodes on the longest path, a single external node has
/// height 1 (B4).
///
/// With D_h = P(H > h) and L_h = P(H <= h) of a tree and of its children a, b, over the splits: D_h = sum of
/// P (D_(h-1)(a) + D_(h-1)(b) (1 - D_(h-1)(a))) where that is at most 1/2, and below that L_h = sum of P
/// L_(h-1)(a) L_(h-1)(b). Positive terms only, and of D and L the smaller one is computed, so both tails keep
/// their relative accuracy: 1e-12 where D or L is above 1e-20, if the rows of the splits have it. Tails are
/// carried on to 1e-35, since deep nodes of large trees add up the unlikely heights of small ones. Memory O(n
/// w), time O(n^2 w), w the number of heights stored for one size: about 65 for bst at n = 1000, 18 sqrt(n)
/// for catalan.
class HeightLaw {
 public:
  /// Only size 0 is known at first.
  HeightLaw();

  Size sizes() const { return places_.size(); }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  /// P(H_n > h).
  double above(Size n, Size h) const;

  /// P(H_n <= h).
  double at_most(Size n, Size h) const;

  /// P(H_n = h), h = lowest(n) + 0, 1, ...: differences within one tail. Heights beyond which a tail is below
  /// 1e-20 are left out. O(w).
  std::vector<double> pmf(Size n) const;

  /// The smallest height that pmf(n) holds: P(H_n <= h) >= 1e-20.
  Size lowest(Size n) const;

  Moments moments(Size n) const;

 private:
  /// L is 0 at h < lowest and kept to middle, D is kept from there and 0 at h >= high.
  struct Place {
    Size lowest, middle, high;
  };
  /// One height h and all sizes; what lies beyond the last one known is 0 or 1.
  struct Level {
    TailSeries above;
    SizeSeries at_most;
  };

  Place reach(const SplitRow& row) const;
  Place upper_tail(const SplitRow& row, Place place);
  Place lower_tail(const SplitRow& row, Place place);
  TailSeries& above_at(Size h);
  SizeSeries& at_most_at(Size h);
  double at(Size n, Size h) const;

  std::vector<Place> places_;
  std::vector<Level> levels_;
};

}  // namespace ramify
