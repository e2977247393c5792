#pragma once

#include "ramify/model/weight_window.hpp"

namespace ramify {

/// The beta-binomial weights C(trials, k) Gamma(k+a) Gamma(trials-k+b) of k = 0..trials: k ~ Binomial(trials,
/// X), X ~ beta(a,b). Between 1 and trials-1 they are positive for a, b > -1 too.
struct BetaBinomial {
  Size trials;
  double a;
  double b;

  /// The weights of first..last, scaled to sum 1; window.first is counted from `first` on. Relative error
  /// below 1e-10 (exact ratios outwards from start, one rounding or two a step).
  ///
  /// @param start   where the weights are largest, first..last
  /// @param cutoff  weights beyond which all are below cutoff times that at start are left out; 0 for none,
  ///                as it must be where the weights rise again on the other side
  /// O(length).
  WeightWindow window(Size first, Size last, Size start, double cutoff) const;

 private:
  /// Weight of k+1 over weight of k; 1 at a = b = 1.
  double up(Size k) const;
};

}  // namespace ramify
