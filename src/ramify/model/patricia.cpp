#include "ramify/model/patricia.hpp"

#include <numeric>

#include "ramify/model/binomial_weights.hpp"
#include "ramify/model/parameter.hpp"

namespace ramify {

Patricia::Patricia(double p) : p_(p) {
  require_probability("patricia(p)", "p", p);
}

std::vector<double> Patricia::pmf(Size n) const {
  const std::vector<double> strings = binomial_weights(n + 1, p_);
  std::vector<double> weights(strings.begin() + 1, strings.end() - 1);
  const double inner = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= inner;
  return weights;
}

}  // namespace ramify
