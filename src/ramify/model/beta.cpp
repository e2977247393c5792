#include "ramify/model/beta.hpp"

#include <boost/math/special_functions/beta.hpp>

#include "ramify/model/model_info.hpp"

namespace ramify {

Beta::Beta(double a, double b) : a_(a), b_(b) {
  require_domain(info(), std::array{a, b});
}

Beta::Tails Beta::tails(Size i, Size n) const {
  const double x = static_cast<double>(i) / static_cast<double>(n);
  const double below = boost::math::ibeta(a_, b_, x);
  if (below < 0.5) return {below, 1 - below};
  const double above = boost::math::ibetac(a_, b_, x);
  return {1 - above, above};
}

double Beta::between(const Tails& low, const Tails& high) {
  return high.below < 0.5 ? high.below - low.below : low.above - high.above;
}

double Beta::cell_probability(Size i, Size n) const {
  return between(tails(i, n), tails(i + 1, n));
}

WeightWindow Beta::window(Size n, double) const {
  std::vector<double> weights;
  weights.reserve(n);
  Tails low = tails(0, n);
  for (Size i = 0; i < n; ++i) {
    const Tails high = tails(i + 1, n);
    weights.push_back(between(low, high));
    low = high;
  }
  return {0, std::move(weights)};
}

SplitCharacter Beta::character() const {
  const BetaFraction fraction{a_, b_, Scatter::none};
  return {fraction, a_ == b_, {40, 240}, reach_of(fraction)};
}

const ModelInfo& Beta::info() {
  static const ModelInfo info{
      .name = "beta",
      .parameters = {beta_shape("a"), beta_shape("b")},
      .largest_n = largest_size(),
      .description = "left = floor(nX), X ~ beta(a,b)",
      .source = "A5, A8; Kruszewski 1996, 2.5.2",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Beta(v[0], v[1])); }};
  return info;
}

}  // namespace ramify
