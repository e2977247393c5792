#pragma once

#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {

/// Random PATRICIA tree on n+1 bit strings (A13): left = K-1, K ~ Binomial(n+1, p) given 1 <= K <= n.
///
/// K strings have 0 at the first bit that tells any two apart; every child holds one string at least, or the
/// node would have been contracted. 0 < p < 1 is the probability of left; n <= 2^50. Kruszewski 1996, 3.2.2
/// and B.2.
class Patricia {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless 0 < p < 1.
  explicit Patricia(double p);

  double p() const { return p_; }

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return inner_binomial_variate(stream, n + 1, p_) - 1;
  }

  /// P(left = i) = C(n+1, i+1) p^(i+1) q^(n-i) / (1 - p^(n+1) - q^(n+1)).
  /// The cutoff is of the mode of Binomial(n+1, p).
  WeightWindow window(Size n, double cutoff) const;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const Patricia&, const Patricia&) = default;

 private:
  double p_;
};

}  // namespace ramify
