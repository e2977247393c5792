#pragma once

#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The law on 0..n-1 of a split that is certain: 1 at `left`, 0 elsewhere. O(n).
inline std::vector<double> point_mass(Size n, Size left) {
  std::vector<double> weights(n, 0.0);
  weights[left] = 1;
  return weights;
}

}  // namespace ramify
