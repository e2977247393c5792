#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// F = 1 + the minimum over the children.
struct FillLevelJoin {
  static void add(double weight, const BoundedPmf& a, const BoundedPmf& b, bool, std::ptrdiff_t top,
                  double* out) {
    for (std::ptrdiff_t k = 1; k <= top; ++k)
      out[k] += weight * (a.at[k - 1] * b.from[k - 1] + a.from[k] * b.at[k - 1]);
  }
};

/// P(F_n = k), F_n the fill level; external nodes are counted, the root is level 0. B18.
using FillLevelLaw = BoundedLaw<FillLevelJoin>;

}  // namespace ramify
