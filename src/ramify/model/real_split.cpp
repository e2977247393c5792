#include "ramify/model/real_split.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/log1p.hpp>

namespace ramify {
namespace {

constexpr double stirling_from = 20;  // the first term left out is below 1e-17 there

/// log Gamma(x) - ((x - 1/2) log x - x + log(2 pi)/2).
double stirling_rest(double x) {
  const double t = 1 / (x * x);
  return (1.0 / 12 -
          t * (1.0 / 360 - t * (1.0 / 1260 - t * (1.0 / 1680 - t * (1.0 / 1188 - t * 691.0 / 360360))))) /
         x;
}

/// log1p(t) - t.
double log1p_rest(double t) {
  return boost::math::log1pmx(t);
}

/// x log(x/mean) + mean - x for x = mean + deviation: what x lies above or below its mean, in units of
/// likelihood.
double deviance(double mean, double deviation) {
  const double t = deviation / mean;
  // (1+t) log(1+t) - t = (1+t) (log1p(t) - t) + t^2.
  return mean * ((1 + t) * log1p_rest(t) + t * t);
}

}  // namespace

double log_gamma_excess(double x, double c) {
  if (x < stirling_from || x + c < stirling_from)
    return boost::math::lgamma(x + c) - boost::math::lgamma(x) - c * std::log(x);
  const double t = c / x;
  return x * log1p_rest(t) + (c - 0.5) * std::log1p(t) + stirling_rest(x + c) - stirling_rest(x);
}

double BinomialSplit::log_weight(double trials, double p, double deviation) {
  const double k = trials * p + deviation, other = trials * (1 - p) - deviation;
  if (k <= 0 || other <= 0) return -std::numeric_limits<double>::infinity();  // far from the mean: unused
  // Gamma(trials+1) = trials Gamma(trials), and so for the others.
  return stirling_rest(trials) - stirling_rest(k) - stirling_rest(other) - deviance(trials * p, deviation) -
         deviance(trials * (1 - p), -deviation) - 0.5 * std::log(2 * std::numbers::pi * (k / trials) * other);
}

}  // namespace ramify
