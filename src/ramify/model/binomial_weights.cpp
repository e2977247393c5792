#include "ramify/model/binomial_weights.hpp"

#include <algorithm>
#include <numeric>

namespace ramify {

WeightWindow binomial_window(Size m, double p, double cutoff) {
  // Ratios from the mode outwards lose one rounding a step and underflow only where the weight itself does;
  // the sum, which is 1, then fixes the scale.
  const Size mode = std::min(m, static_cast<Size>(static_cast<double>(m + 1) * p));
  const double odds = p / (1 - p);
  std::vector<double> weights{1};
  for (Size k = mode; k > 0; --k) {
    const double next = weights.back() * (static_cast<double>(k) / (odds * static_cast<double>(m - k + 1)));
    if (next < cutoff) break;
    weights.push_back(next);
  }
  const Size first = mode + 1 - weights.size();
  std::reverse(weights.begin(), weights.end());
  for (Size k = mode; k < m; ++k) {
    const double next = weights.back() * (odds * static_cast<double>(m - k) / static_cast<double>(k + 1));
    if (next < cutoff) break;
    weights.push_back(next);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= sum;
  return {first, std::move(weights)};
}

std::vector<double> binomial_weights(Size m, double p) {
  return binomial_window(m, p, 0).weights;
}

}  // namespace ramify
