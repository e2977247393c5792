#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// S = k where one child has order k and the other less, or both have k-1 (leaf order 0).
struct StrahlerJoin {
  static void add(double weight, const BoundedPmf& a, const BoundedPmf& b, bool, std::ptrdiff_t top,
                  double* out) {
    for (std::ptrdiff_t k = 0; k <= top; ++k)
      out[k] += weight * (a.at[k] * b.below[k] + a.below[k] * b.at[k] + a.at[k - 1] * b.at[k - 1]);
  }
};

/// P(S_n = k), S_n the Horton-Strahler number. External nodes have order 0. B6.
using StrahlerLaw = BoundedLaw<StrahlerJoin>;

}  // namespace ramify
