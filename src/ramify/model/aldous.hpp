#pragma once

#include "ramify/model/inner_fraction.hpp"
#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {

/// Beta-splitting tree of Aldous: of its m = n+1 leaves, k = 1..n go left with probability proportional to
///   f(k) f(m-k),   f(k) = Gamma(beta+1+k) / k!
/// (left = k-1). beta > -2, n <= 2^50. Aldous 1996, 2001.
///
/// beta = 0 is the BST (the Yule tree), -3/2 catalan; at -1 the weights are 1/(k(m-k)) and depths turn from
/// powers of n to powers of log n. As beta -> -2 chains, as beta -> infinity patricia(1/2).
class Aldous {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless beta is finite and above -2.
  explicit Aldous(double beta);

  double beta() const { return beta_; }

  /// O(1) expected, whatever beta and n: nothing here is a Gamma function.
  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    const Size leaves = leaves_of_a_side(n, stream);
    const bool on_the_left = stream() >> 63 != 0;
    return on_the_left ? leaves - 1 : n - leaves;
  }

  /// f(k) f(m-k), k = left+1, scaled to sum 1; all of it for beta < 0, where both ends are modes. Relative
  /// error below 1e-10 (BetaBinomial). O(length).
  WeightWindow window(Size n, double cutoff) const;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const Aldous&, const Aldous&) = default;

 private:
  /// k with weight f(k) (m-k) f(m-k), k = 1..n. With a fair coin for the side that is the split law, for
  /// f(k) f(m-k) (k + (m-k)) is the sum of both sides' weights; and it is Binomial(n, X), X ~ beta(a, a+1), a
  /// = beta+1, given k >= 1: only one end is forbidden.
  template <class Urbg>
  Size leaves_of_a_side(Size n, Urbg& stream) const {
    const double a = beta_ + 1;
    if (a < 1) return positive_binomial_variate(stream, n, InnerFraction(a, n)(stream));
    for (;;) {
      // k = 0 has probability 2/(n+2) at beta = 0, and less above.
      const Size leaves = binomial_variate(stream, n, beta_variate(stream, a, a + 1));
      if (leaves >= 1) return leaves;
    }
  }

  double beta_;
};

}  // namespace ramify
