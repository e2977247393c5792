#pragma once

#include <vector>

#include "ramify/law/moments.hpp"
#include "ramify/law/split_rows.hpp"

namespace ramify {

/// The exact law of the height H_n for every size 0..n: nodes on the longest path, a single external node has
/// height 1 (B4).
///
/// With D_h = P(H > h) of a tree and of its children a, b: D_h = sum over splits of P (1 - (1 - D_(h-1)(a))
/// (1 - D_(h-1)(b))). Every D keeps its relative accuracy in the upper tail; 1 - D is right to 1e-15 in
/// absolute terms. Heights with D < 1e-20 or 1 - D < 5e-16 are not stored. Memory O(n w), time O(n^2 w), w
/// the number of heights stored for one size: about 40 for bst at n = 1000, 13 sqrt(n) for catalan.
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
  double at_most(Size n, Size h) const { return 1 - above(n, h); }

  /// P(H_n = h), h = lowest(n) + 0, 1, ...: differences of D, so the upper tail keeps the relative accuracy
  /// of those. O(w).
  std::vector<double> pmf(Size n) const;

  /// The smallest height that pmf(n) holds.
  Size lowest(Size n) const { return places_[n].low; }

  Moments moments(Size n) const;

 private:
  /// D is 1 at h < low, 0 at h >= high.
  struct Place {
    Size low;
    Size high;
    std::size_t begin;
  };

  Place reach(const SplitRow& row) const;
  void add_pair(double weight, const Place& a, const Place& b, Size low);
  void append(Size low);

  std::vector<Place> places_;
  std::vector<double> above_;
  std::vector<double> out_;      ///< D of the new size, from its low on
  std::vector<double> certain_;  ///< weight of the pairs that are 1 below this height
};

}  // namespace ramify
