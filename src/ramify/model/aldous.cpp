#include "ramify/model/aldous.hpp"

#include <array>
#include <cmath>

#include "ramify/model/beta_binomial.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {

Aldous::Aldous(double beta) : beta_(beta) {
  require_domain(info(), std::array{beta});
}

WeightWindow Aldous::window(Size n, double cutoff) const {
  const BetaBinomial leaves{n + 1, beta_ + 1, beta_ + 1};
  return beta_ < 0 ? leaves.window(1, n, 1, 0) : leaves.window(1, n, (n + 1) / 2, cutoff);
}

SplitCharacter Aldous::character() const {
  const BetaFraction fraction{beta_ + 1, beta_ + 1, Scatter::strings};
  return {fraction, true, {.nanoseconds = 12}, reach_of(fraction)};
}

/// f(x) f(y), f(k) = Gamma(beta+1+k) / Gamma(k+1).
RealSplit Aldous::real_split() const {
  return SmoothSplit{[beta = beta_](double x, double y) {
                       return beta * (std::log(x + 1) + std::log((y + 1) / (x + y))) +
                              log_gamma_excess(x + 1, beta) + log_gamma_excess(y + 1, beta);
                     },
                     false};
}

const ModelInfo& Aldous::info() {
  static const ModelInfo info{
      .name = "aldous",
      .parameters = {{.name = "beta",
                      .domain = {.low = -2},
                      .remedy = "give a number above -2: 0 for the bst, -1.5 for catalan, -1 in between"}},
      .largest_n = largest_size(),
      .description =
          "beta-splitting: k of m = n+1 leaves left with weight f(k) f(m-k), f(k) = Gamma(beta+1+k)/k!",
      .source = "Aldous 1996",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Aldous(v[0])); }};
  return info;
}

}  // namespace ramify
