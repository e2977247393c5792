#pragma once

#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// C(m, k) p^k (1-p)^(m-k), k = 0..m: relative error below 1e-12 each (exact ratios outwards from the mode,
/// scaled to sum 1). 0 < p < 1. O(m).
std::vector<double> binomial_weights(Size m, double p);

}  // namespace ramify
