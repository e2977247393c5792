#include "ramify/model/binomial_weights.hpp"

#include <algorithm>
#include <numeric>

namespace ramify {

WeightWindow binomial_window(Size m, double p, double cutoff) {
  const Size mode = std::min(m, static_cast<Size>(static_cast<double>(m + 1) * p));
  const double odds = p / (1 - p);
  WeightWindow window = weights_outward(
      mode, m, cutoff,
      [=](Size k) { return static_cast<double>(k) / (odds * static_cast<double>(m - k + 1)); },
      [=](Size k) { return odds * static_cast<double>(m - k) / static_cast<double>(k + 1); });
  const double sum = std::accumulate(window.weights.begin(), window.weights.end(), 0.0);
  for (double& w : window.weights) w /= sum;
  return window;
}

}  // namespace ramify
