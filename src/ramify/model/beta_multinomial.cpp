#include "ramify/model/beta_multinomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "ramify/model/beta_binomial.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {

BetaMultinomial::BetaMultinomial(double a, double b) : a_(a), b_(b) {
  require_domain(info(), std::array{a, b});
}

Size BetaMultinomial::mode(Size last) const {
  if (a_ <= 1 || b_ <= 1) return a_ <= b_ ? 0 : last;
  const double share = 1 / (1 + (b_ - 1) / (a_ - 1));
  return std::min(last, static_cast<Size>(share * static_cast<double>(last)));
}

WeightWindow BetaMultinomial::window(Size n, double cutoff) const {
  const Size last = n - 1;
  return BetaBinomial{last, a_, b_}.window(0, last, mode(last), a_ < 1 && b_ < 1 ? 0 : cutoff);
}

SplitCharacter BetaMultinomial::character() const {
  const BetaFraction fraction{a_, b_, Scatter::binomial};
  return {fraction, a_ == b_, {.nanoseconds = 12}, reach_of(fraction)};
}

/// Gamma(x-1+a)/Gamma(x) Gamma(y-1+b)/Gamma(y) Gamma(z-1)/Gamma(z-2+a+b) / B(a,b), z = x+y leaves: powers of
/// the shares x/z and y/z, 1/z, and what is left of the Gammas beside powers.
RealSplit BetaMultinomial::real_split() const {
  const double log_beta = boost::math::lgamma(a_) + boost::math::lgamma(b_) - boost::math::lgamma(a_ + b_);
  return SmoothSplit{[=, a = a_, b = b_](double x, double y) {
                       const double z = x + y;
                       return (a - 1) * std::log(x / z) + (b - 1) * std::log(y / z) - std::log(z) -
                              (a + b - 1) * std::log1p(-1 / z) + log_gamma_excess(x, a - 1) +
                              log_gamma_excess(y, b - 1) - log_gamma_excess(z - 1, a + b - 1) - log_beta;
                     },
                     true};
}

const ModelInfo& BetaMultinomial::info() {
  static const ModelInfo info{
      .name = "beta_multinomial",
      .parameters = {beta_shape("a"), beta_shape("b")},
      .largest_n = largest_size(),
      .description = "left ~ Bin(n-1,X), X ~ beta(a,b)",
      .source = "A8; Devroye 1986, 1998",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(BetaMultinomial(v[0], v[1])); }};
  return info;
}

}  // namespace ramify
