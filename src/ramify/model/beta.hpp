#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {

/// Beta split tree, floor model (A5, A8): left = floor(nX), X ~ beta(a,b) fresh at every node. Kruszewski
/// 1996, 2.5.2.
///
/// a, b > 0 (tested from 0.01 to 1000); n <= 2^50. beta(1,1) is the BST.
class Beta {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless a and b are finite and positive.
  Beta(double a, double b);

  double a() const { return a_; }
  double b() const { return b_; }

  /// floor(nX), taken from the end that X is nearer to, so that X = 1 - 1e-30 still leaves exactly 0 on the
  /// right.
  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    const UnitPair pair = beta_variate(stream, a_, b_);
    const double size = static_cast<double>(n);
    if (pair.x <= pair.complement) return std::min(static_cast<Size>(size * pair.x), n - 1);
    const auto right_and_root = static_cast<Size>(std::ceil(size * pair.complement));
    return n - std::clamp(right_and_root, Size{1}, n);
  }

  /// P(left = i) of every i: cell_probability.
  std::vector<double> pmf(Size n) const;

  /// P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b), the difference taken on the side where the incomplete
  /// beta is small.
  double cell_probability(Size i, Size n) const;

  friend bool operator==(const Beta&, const Beta&) = default;

 private:
  /// P(X < x) and P(X > x): the smaller of them to full relative precision.
  struct Tails {
    double below, above;
  };

  Tails tails(Size i, Size n) const;  ///< at x = i/n
  static double between(const Tails& low, const Tails& high);

  double a_;
  double b_;
};

}  // namespace ramify
