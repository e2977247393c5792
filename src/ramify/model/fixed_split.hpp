#pragma once

#include <algorithm>
#include <vector>

#include "ramify/model/split_law.hpp"

namespace ramify {

/// Deterministic split tree (A6): left = floor(nx) at every node. 0 < x < 1, n <= 2^50. Kruszewski
/// 1996, 2.5.1. The product n x is taken in double precision: x is the double nearest to what was written.
class FixedSplit {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = false;

  /// Throws Error unless 0 < x < 1.
  explicit FixedSplit(double x);

  double x() const { return x_; }

  template <class Urbg>
  Size left(Size n, Urbg&) const {
    return left(n);
  }

  Size left(Size n) const { return std::min(static_cast<Size>(static_cast<double>(n) * x_), n - 1); }

  /// 1 at floor(nx), 0 elsewhere.
  std::vector<double> pmf(Size n) const;

  friend bool operator==(const FixedSplit&, const FixedSplit&) = default;

 private:
  double x_;
};

}  // namespace ramify
