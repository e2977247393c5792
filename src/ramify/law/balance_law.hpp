#pragma once

#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// B = max(1 + B of the smaller child, B of the larger); 1 + the maximum where the sizes are equal.
struct BalanceJoin {
  static void add(double weight, const BoundedPmf& smaller, const BoundedPmf& larger, bool same_size,
                  std::ptrdiff_t top, double* out) {
    const std::ptrdiff_t raised = same_size ? 1 : 0;  // by how much the edge to the larger child raises
    for (std::ptrdiff_t k = 0; k <= top; ++k) {
      const double smaller_leads = smaller.at[k - 1] * larger.below[k + 1 - raised];
      const double larger_leads = smaller.below[k - 1] * larger.at[k - raised];
      out[k] += weight * (smaller_leads + larger_leads);
    }
  }
};

/// P(B_n = k), B_n the balance number. External nodes have 0. B16.
using BalanceLaw = BoundedLaw<BalanceJoin>;

}  // namespace ramify
