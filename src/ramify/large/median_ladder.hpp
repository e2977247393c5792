#pragma once

#include <cstddef>
#include <vector>

#include "ramify/estimate/limit_slope.hpp"
#include "ramify/large/large_law.hpp"

namespace ramify {

/// The sizes at which a whole-valued statistic X reaches its values: log n_k with P(X_n >= k) = 1/2.
///
/// E X_n of such a statistic goes up in steps, one for each value, which no fit of E X_n against log n sees
/// past; n_k does not: X_n ~ c log n where log n_k ~ k/c. P(X_n >= k) must grow with n.
class MedianLadder {
 public:
  /// @param law    of X up to `largest`, from large_law_table on; must outlive this
  MedianLadder(const LargeLaw& law, AffineMap map, double smallest, double largest);

  /// The greatest value that has a rung below the largest size, the least above the smallest.
  std::size_t highest() const { return highest_; }
  std::size_t lowest() const { return lowest_; }

  /// (k, log n_k) with the error that those of the law leave: P +- error passes 1/2 within it. Cost: some 100
  /// laws.
  /// @param k  lowest()..highest()
  KnownPoint rung(std::size_t k) const;

 private:
  double crossing(std::size_t k, double side) const;
  std::size_t median(double n) const;

  const LargeLaw* law_;
  AffineMap map_;
  double from_, to_;  ///< logarithms of sizes
  std::size_t lowest_, highest_;
};

}  // namespace ramify
