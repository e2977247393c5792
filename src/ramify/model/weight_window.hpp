#pragma once

#include <algorithm>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Consecutive probabilities: weights[m] = P(first + m); the rest is negligible.
struct WeightWindow {
  Size first = 0;
  std::vector<double> weights;
};

/// The weights of a law on 0..last relative to that of `start`, outwards from there by exact ratios, as far
/// as they are at least cutoff; not scaled.
///
/// One rounding or two are lost a step, and a weight underflows only where it is negligible beside the one at
/// the start.
/// @param down  down(k) = w_(k-1) / w_k, 0 < k <= last
/// @param up    up(k) = w_(k+1) / w_k, 0 <= k < last
/// O(length).
template <class Down, class Up>
WeightWindow weights_outward(Size start, Size last, double cutoff, Down down, Up up) {
  std::vector<double> weights{1};
  for (Size k = start; k > 0; --k) {
    const double next = weights.back() * down(k);
    if (next < cutoff) break;
    weights.push_back(next);
  }
  const Size first = start + 1 - weights.size();
  std::reverse(weights.begin(), weights.end());
  for (Size k = start; k < last; ++k) {
    const double next = weights.back() * up(k);
    if (next < cutoff) break;
    weights.push_back(next);
  }
  return {first, std::move(weights)};
}

}  // namespace ramify
