#include "ramify/model/beta_binomial.hpp"

#include "ramify/core/compensated_sum.hpp"

namespace ramify {

double BetaBinomial::up(Size k) const {
  const auto left = static_cast<double>(k), right = static_cast<double>(trials - k);
  return right / (right - 1 + b) * ((left + a) / (left + 1));
}

WeightWindow BetaBinomial::window(Size first, Size last, Size start, double cutoff) const {
  WeightWindow found = weights_outward(
      start - first, last - first, cutoff, [&](Size i) { return 1 / up(first + i - 1); },
      [&](Size i) { return up(first + i); });
  // Plainly summed, thousands of small weights and one heavy end would miss 1 by 1e-14.
  const double sum = compensated_sum(found.weights);
  for (double& w : found.weights) w /= sum;
  return found;
}

}  // namespace ramify
