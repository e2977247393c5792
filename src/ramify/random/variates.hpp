#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/random/binomial_distribution.hpp>
#include <boost/random/normal_distribution.hpp>

#include "ramify/core/contract.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {

/// X in (0,1) with its complement, each to full relative precision: near 1, x alone would lose 1-x.
struct UnitPair {
  double x;
  double complement;
};

/// G ~ gamma(shape, 1), shape >= 1: rejection from a cubed normal (Marsaglia and Tsang 2000).
///
/// Boost.Random has a gamma of its own, by a tangent: six times slower (bench/random_bench.cpp), and half the
/// time of a grafted beta tree. Its normal is a ziggurat.
template <class Urbg>
double gamma_variate(Urbg& stream, double shape) {
  RAMIFY_EXPECTS(shape >= 1);
  const double d = shape - 1.0 / 3, c = 1 / std::sqrt(9 * d);
  boost::random::normal_distribution<double> normal;
  for (;;) {
    const double x = normal(stream), root = 1 + c * x;
    if (root <= 0) continue;
    const double v = root * root * root, u = uniform_open(stream), square = x * x;
    if (u < 1 - 0.0331 * square * square) return d * v;
    if (std::log(u) < square / 2 + d * (1 - v + std::log(v))) return d * v;
  }
}

/// log G of a gamma(shape, 1) variate G, shape > 0.
///
/// For shape < 1, G = G' U^(1/shape) with G' ~ gamma(shape+1) (Marsaglia and Tsang 2000, section 8); taken in
/// logs, because G itself underflows to 0 with probability 0.06 at shape 0.004 and often below.
template <class Urbg>
double log_gamma_variate(Urbg& stream, double shape) {
  if (shape >= 1) return std::log(gamma_variate(stream, shape));
  const double boosted = std::log(gamma_variate(stream, shape + 1));
  return boosted + std::log(uniform_open(stream)) / shape;
}

/// X ~ beta(a,b) and 1-X, a, b > 0 (0.01 to 1000 tested).
///
/// X = G_a / (G_a + G_b). Where a or b is below 1 the plain quotient may be 0/0 or exactly 1, so it is taken
/// from the logs: X = 1/(1+e^-d), 1-X = 1/(1+e^d), d = log G_a - log G_b.
template <class Urbg>
UnitPair beta_variate(Urbg& stream, double a, double b) {
  if (a >= 1 && b >= 1) {
    const double left = gamma_variate(stream, a);
    const double right = gamma_variate(stream, b);
    return {left / (left + right), right / (left + right)};
  }
  // One statement each: the order of two draws in one expression is the compiler's to choose.
  const double log_left = log_gamma_variate(stream, a);
  const double log_ratio = log_left - log_gamma_variate(stream, b);
  return {1 / (1 + std::exp(-log_ratio)), 1 / (1 + std::exp(log_ratio))};
}

/// K ~ Binomial(trials, p), 0 < p < 1 (Boost.Random: Hormann's BTRD 1993, inversion for small means).
template <class Urbg>
std::uint64_t binomial_variate(Urbg& stream, std::uint64_t trials, double p) {
  boost::random::binomial_distribution<std::int64_t, double> law(static_cast<std::int64_t>(trials), p);
  return static_cast<std::uint64_t>(law(stream));
}

/// A binomial law's inversion: from its weight `term` at k upwards until they add up to rest, at most to
/// last.
///
/// Where rounding has kept the weights below rest it ends with the weights of the tail, at `negligible`.
inline std::uint64_t invert_binomial(std::uint64_t trials, double odds, std::uint64_t k, double term,
                                     double rest, std::uint64_t last, double negligible) {
  while (rest > term && k < last) {
    const double next = term * odds * static_cast<double>(trials - k) / static_cast<double>(k + 1);
    if (next < term && next < negligible) break;
    rest -= term;
    term = next;
    ++k;
  }
  return k;
}

/// K ~ Binomial(trials, p) for a p that is itself a variate: p and 1-p to full relative precision, 0 and 1
/// included.
///
/// Rare successes are inverted here: Boost's inversion takes 1-p in double precision, which is off by up to
/// 5e-17, and a p of that order still comes to something among 2^50 trials.
template <class Urbg>
std::uint64_t binomial_variate(Urbg& stream, std::uint64_t trials, const UnitPair& p) {
  if (p.x > p.complement) return trials - binomial_variate(stream, trials, UnitPair{p.complement, p.x});
  if (p.x == 0) return 0;
  const double m = static_cast<double>(trials);
  constexpr double boost_inverts_below = 11;
  if ((m + 1) * p.x >= boost_inverts_below) return binomial_variate(stream, trials, p.x);
  return invert_binomial(trials, p.x / (1 - p.x), 0, std::exp(m * std::log1p(-p.x)), uniform_open(stream),
                         trials, std::numeric_limits<double>::epsilon());
}

/// K ~ Binomial(trials, p) given 1 <= K <= last, by inversion from 1 on, and given = P(1 <= K <= last).
template <class Urbg>
std::uint64_t invert_binomial_from_one(Urbg& stream, std::uint64_t trials, const UnitPair& p,
                                       std::uint64_t last, double given) {
  const double m = static_cast<double>(trials), odds = p.x / p.complement;
  const double one = std::exp(m * std::log1p(-p.x)) * m * odds;
  return invert_binomial(trials, odds, 1, one, uniform_open(stream) * given, last,
                         std::numeric_limits<double>::epsilon() * given);
}

/// K ~ Binomial(trials, p) given K >= 1; trials >= 1. At p = 0 and 1 the limits, 1 and trials.
///
/// Inversion where K = 0 is likely, so that p = 1e-9 costs no more than p = 1/2; else rejection.
template <class Urbg>
std::uint64_t positive_binomial_variate(Urbg& stream, std::uint64_t trials, const UnitPair& p) {
  RAMIFY_EXPECTS(trials >= 1);
  const double m = static_cast<double>(trials);
  if (p.x <= 0.5 && m * p.x <= 8)
    return invert_binomial_from_one(stream, trials, p, trials, -std::expm1(m * std::log1p(-p.x)));
  for (;;) {
    const std::uint64_t k = binomial_variate(stream, trials, p);
    if (k >= 1) return k;
  }
}

/// K ~ Binomial(trials, p) given 1 <= K <= trials-1; trials >= 2, 0 < p < 1: how many of `trials` strings go
/// left at a branching node of a PATRICIA tree.
///
/// Rejection from the binomial where both ends are rare; else inversion from the rarer end, so that p = 1e-9
/// costs no more than p = 1/2.
template <class Urbg>
std::uint64_t inner_binomial_variate(Urbg& stream, std::uint64_t trials, double p) {
  RAMIFY_EXPECTS(trials >= 2 && p > 0 && p < 1);
  if (p > 0.5) return trials - inner_binomial_variate(stream, trials, 1 - p);
  const double m = static_cast<double>(trials);
  if (m * p > 8) {
    for (;;) {
      const std::uint64_t k = binomial_variate(stream, trials, p);
      if (k >= 1 && k < trials) return k;
    }
  }
  const double inner = -std::expm1(m * std::log1p(-p)) - std::pow(p, m);
  return invert_binomial_from_one(stream, trials, UnitPair{p, 1 - p}, trials - 1, inner);
}

}  // namespace ramify
