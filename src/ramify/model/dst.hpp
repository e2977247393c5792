#pragma once

#include "ramify/model/binomial_weights.hpp"
#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {

/// Digital search tree on n random bit strings (A11): left ~ Binomial(n-1, p). 0 < p < 1, n <= 2^50.
///
/// The thesis calls it the binomial split tree and takes it for PATRICIA (3.2.2), which it is only
/// asymptotically; it also writes Binomial(n, p), which can leave the range 0..n-1 (X16).
class Dst {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless 0 < p < 1.
  explicit Dst(double p);

  double p() const { return p_; }

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return binomial_variate(stream, n - 1, p_);
  }

  /// P(left = i) = C(n-1, i) p^i q^(n-1-i).
  WeightWindow window(Size n, double cutoff) const { return binomial_window(n - 1, p_, cutoff); }

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const Dst&, const Dst&) = default;

 private:
  double p_;
};

}  // namespace ramify
