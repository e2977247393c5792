#pragma once

#include <algorithm>
#include <array>
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
  WeightWindow window(Size n, double cutoff) const;

  class Rows;

  /// P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b), the difference taken on the side where the incomplete
  /// beta is small.
  double cell_probability(Size i, Size n) const;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

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

/// The split laws of a floor-model beta tree, size after size: P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b).
///
/// With j = n-1-i, the density over the cell of i is n^-(a+b-1) (i+t)^(a-1) (j+1-t)^(b-1) / B(a,b), t in
/// (0,1): Gauss and Legendre's 8 points, whose powers of i+t and j+1-t are tabulated once for all n. So an
/// entry costs one exponential and 8 products instead of two incomplete betas. Cells near the ends, where the
/// powers are singular, and cells over which the density changes by more than e^4 are taken from the
/// incomplete beta. Relative error below 1e-10 where the weight is above 1e-15 (tests/exact).
class Beta::Rows {
 public:
  explicit Rows(const Beta& law);

  /// P(left = i), i = 0..n-1; entries below 1e-25 are 0. O(n).
  WeightWindow window(Size n);

 private:
  static constexpr std::size_t points = 8;

  void extend_tables(Size n);
  double change(Size i, Size n) const;

  Beta law_;
  double log_beta_;
  std::vector<std::array<double, points>> left_;   ///< ((i + t) / (i + 1/2))^(a-1), times the weight of t
  std::vector<std::array<double, points>> right_;  ///< ((j + 1 - t) / (j + 1/2))^(b-1)
  std::vector<double> log_left_;                   ///< (a-1) log(i + 1/2)
  std::vector<double> log_right_;                  ///< (b-1) log(j + 1/2)
};

}  // namespace ramify
