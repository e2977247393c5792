#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A number and a bound of its absolute error, computed with it.
struct Approximation {
  double value;
  double error;
};

/// Three computations of the same laws of large trees: from the exact laws to `table` on a grid of step d; on
/// one of step 2d; and so from the exact laws to table/2. What their answers differ by tells the error of the
/// first: the grid's falls like d^8 (divided by 8 here, not by 256: it need not yet), the seam's counts
/// three times, for it may be small by chance.
template <class Solution>
class Refined {
 public:
  /// @param solve        std::unique_ptr<Solution> of a table's size and a step
  /// @param fine_enough  whether these three will do; else d is halved, four times at most
  template <class Solve, class FineEnough>
  Refined(Size table, Solve solve, FineEnough fine_enough)
      : fine_(solve(table, first_step)),
        coarse_(solve(table, 2 * first_step)),
        early_(solve(table / 2, 2 * first_step)) {
    double step = first_step;
    for (int halved = 0; halved < halvings && !fine_enough(*this); ++halved) {
      step /= 2;
      coarse_ = std::move(fine_);
      fine_ = solve(table, step);
      early_ = solve(table / 2, 2 * step);
    }
  }

  static Approximation combined(double fine, double coarse, double early) {
    return {fine, std::abs(fine - coarse) / 8 + 3 * std::abs(coarse - early) + rounding * std::abs(fine)};
  }

  const Solution& fine() const { return *fine_; }
  const Solution& coarse() const { return *coarse_; }
  const Solution& early() const { return *early_; }

  static constexpr double rounding = 4e-15;

 private:
  static constexpr double first_step = 0.04;  // at twice of it no half of a size reaches the size itself
  static constexpr int halvings = 4;

  std::unique_ptr<Solution> fine_, coarse_, early_;
};

/// Errors that need no finer grid: absolute, or of what is above 1.
inline bool is_good(const Approximation& estimate) {
  return estimate.error <= 1e-8 * std::max(1.0, std::abs(estimate.value));
}

}  // namespace ramify
