#include "ramify/model/patricia.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "ramify/model/binomial_weights.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {

Patricia::Patricia(double p) : p_(p) {
  require_domain(info(), std::array{p});
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

SplitCharacter Patricia::character() const {
  const ConstantFraction fraction{p_, Scatter::strings};
  return {fraction, p_ == 0.5, {.nanoseconds = 16}, reach_of(fraction)};
}

RealSplit Patricia::real_split() const {
  return BinomialSplit{p_, 0, 0};
}

const ModelInfo& Patricia::info() {
  static const ModelInfo info{
      .name = "patricia",
      .parameters = {probability("p")},
      .largest_n = largest_size(),
      .description = "PATRICIA on n+1 strings: left = K-1, K ~ Bin(n+1,p) given 1 <= K <= n",
      .source = "A13; Kruszewski 1996, 3.2.2",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Patricia(v[0])); }};
  return info;
}

}  // namespace ramify
