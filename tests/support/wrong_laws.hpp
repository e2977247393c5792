#pragma once

#include "support/reference_laws.hpp"

#include "ramify/model/catalan.hpp"
#include "ramify/model/split_law.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/random/variates.hpp"

namespace ramify::test {

// The samplers that a slip would give: what the tests of sampled means must reject.

/// A BST that never puts everything on the left.
struct ShortUniform {
  static constexpr Size largest_size() { return max_size; }
  static constexpr bool uses_table = false;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return uniform_below(stream, n - 1);
  }
  WeightWindow window(Size n, double) const { return {0, short_uniform_law(n)}; }
};

/// Binomial(n, p) given X < n.
struct ThesisBinomial {
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;
  double p;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    for (;;) {
      const std::uint64_t k = binomial_variate(stream, n, p);
      if (k < n) return k;
    }
  }
  WeightWindow window(Size n, double) const { return {0, thesis_binomial_law(n, p)}; }
};

/// PATRICIA split on n strings.
struct ShortPatricia {
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;
  double p;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return inner_binomial_variate(stream, n, p) - 1;
  }
  WeightWindow window(Size n, double) const { return {0, short_patricia_law(n, p)}; }
};

/// C_i C_(n-2-i) in place of C_i C_(n-1-i).
struct ShortCatalan {
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return Catalan().left(n - 1, stream);
  }
  WeightWindow window(Size n, double) const { return {0, short_catalan_law(n)}; }
};

}  // namespace ramify::test
