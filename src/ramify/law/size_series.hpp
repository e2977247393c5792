#pragma once

#include <vector>

#include "ramify/law/split_row.hpp"

namespace ramify {

/// A quantity of trees of size 0, 1, 2, ...: a value for each, and the sizes first..last outside of which it
/// is 0.
class SizeSeries {
 public:
  void reserve(Size sizes) { values_.reserve(sizes); }
  void append(double value);

  /// The sizes 0..sizes()-1 are known.
  Size sizes() const { return values_.size(); }

  double operator[](Size n) const { return values_[n]; }

 private:
  friend double over_children(const SplitRow&, const SizeSeries&, const SizeSeries&);
  friend double over_children(const SplitRow&, const SizeSeries&);

  std::vector<double> values_;
  Size first_ = 1, last_ = 0;
};

/// The sum over the row of weight * a[smaller child] * b[larger child]. O(row), vectorised.
double over_children(const SplitRow& row, const SizeSeries& a, const SizeSeries& b);

/// The sum over the row of weight * (a[smaller child] + a[larger child]). O(row), vectorised.
double over_children(const SplitRow& row, const SizeSeries& a);

}  // namespace ramify
