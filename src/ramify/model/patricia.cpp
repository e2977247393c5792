#include "ramify/model/patricia.hpp"

#include <algorithm>
#include <numeric>

#include "ramify/model/binomial_weights.hpp"
#include "ramify/model/parameter.hpp"

namespace ramify {

Patricia::Patricia(double p) : p_(p) {
  require_probability("patricia(p)", "p", p);
}

WeightWindow Patricia::window(Size n, double cutoff) const {
  // K = 0 or K = n+1 may be nearly all of the binomial law: the cutoff is meant for what is left without
  // them.
  const double inner_share = std::min(1.0, static_cast<double>(n + 1) * std::min(p_, 1 - p_));
  WeightWindow strings = binomial_window(n + 1, p_, cutoff * inner_share);
  auto& weights = strings.weights;
  if (strings.first + weights.size() == n + 2) weights.pop_back();
  if (strings.first == 0) {
    weights.erase(weights.begin());
  } else {
    --strings.first;
  }
  const double inner = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& w : weights) w /= inner;
  return strings;
}

}  // namespace ramify
