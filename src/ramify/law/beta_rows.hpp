#pragma once

#include <array>
#include <vector>

#include "ramify/model/beta.hpp"

namespace ramify {

/// The split laws of a floor-model beta tree, size after size: P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b).
///
/// With j = n-1-i, the density over the cell of i is n^-(a+b-1) (i+t)^(a-1) (j+1-t)^(b-1) / B(a,b), t in
/// (0,1): Gauss and Legendre's 8 points, whose powers of i+t and j+1-t are tabulated once for all n. So an
/// entry costs one exponential and 8 products instead of two incomplete betas. Cells near the ends, where the
/// powers are singular, and cells over which the density changes by more than e^4 are taken from the
/// incomplete beta. Relative error below 1e-10 where the weight is above 1e-15 (tests/exact).
class BetaRows {
 public:
  explicit BetaRows(const Beta& law);

  /// P(left = i), i = 0..n-1; entries below 1e-25 are 0. O(n).
  void fill(Size n, std::vector<double>& weights);

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
