#include "ramify/model/binomial_weights.hpp"

#include <numeric>

namespace ramify {

std::vector<double> binomial_weights(Size m, double p) {
  // Ratios from the mode outwards lose one rounding a step and underflow only where the weight itself does;
  // the sum, which is 1, then fixes the scale.
  const auto mode = static_cast<Size>(static_cast<double>(m + 1) * p);
  std::vector<double> weights(m + 1);
  const Size start = mode > m ? m : mode;
  const double odds = p / (1 - p);
  weights[start] = 1;
  for (Size k = start; k < m; ++k)
    weights[k + 1] = weights[k] * (odds * static_cast<double>(m - k) / static_cast<double>(k + 1));
  for (Size k = start; k > 0; --k)
    weights[k - 1] = weights[k] * (static_cast<double>(k) / (odds * static_cast<double>(m - k + 1)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace ramify
