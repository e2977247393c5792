#pragma once

#include "ramify/model/weight_window.hpp"

namespace ramify {

/// C(m, k) p^k (1-p)^(m-k) for the k around the mode whose weight is at least cutoff times that of the mode;
/// cutoff 0 gives all of 0..m. Relative error below 1e-12 each (exact ratios outwards from the mode, scaled
/// to sum 1). 0 < p < 1. O(length): about 27 sqrt(m p (1-p)) at cutoff 1e-40.
WeightWindow binomial_window(Size m, double p, double cutoff);

}  // namespace ramify
