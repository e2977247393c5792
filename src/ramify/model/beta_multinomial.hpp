#pragma once

#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {

/// Beta split tree, multinomial model (A8): left ~ Binomial(n-1, X), X ~ beta(a,b) fresh at every node.
/// Devroye 1986, 1998.
///
/// a, b > 0 (tested from 0.01 to 1000); n <= 2^50. beta_multinomial(1,1) is the BST.
class BetaMultinomial {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless a and b are finite and positive.
  BetaMultinomial(double a, double b);

  double a() const { return a_; }
  double b() const { return b_; }

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return binomial_variate(stream, n - 1, beta_variate(stream, a_, b_));
  }

  /// P(left = i) = C(n-1, i) B(i+a, n-1-i+b) / B(a,b); all of it where a and b are both below 1, for
  /// then there is a mode at either end. Relative error below 1e-10 (exact ratios outwards from a mode,
  /// scaled to sum 1). O(length).
  WeightWindow window(Size n, double cutoff) const;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const BetaMultinomial&, const BetaMultinomial&) = default;

 private:
  Size mode(Size last) const;

  double a_;
  double b_;
};

}  // namespace ramify
