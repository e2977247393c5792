#include "ramify/law/law_width.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/special_functions/gamma.hpp>

namespace ramify {
namespace {

using boost::math::lgamma;  // std::lgamma writes to a global

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double negligible_depth = 46;   // -log 1e-20
constexpr double negligible_height = 81;  // -log 1e-35
constexpr double spread = 10;  // values by which whole sizes widen what a constant fraction would give

/// log(x + y).
double log_sum(double log_x, double log_y) {
  return std::max(log_x, log_y) + std::log1p(std::exp(-std::abs(log_x - log_y)));
}

/// A limiting split fraction X that is a beta(a,b) variate or a constant.
class Fraction {
 public:
  explicit Fraction(double constant) : constant_(constant) {}

  /// Log-gammas of large parameters cancel, but such an X is as good as constant.
  Fraction(double a, double b) : is_constant_(a + b > 1e6), a_(a), b_(b), constant_(a / (a + b)) {}

  /// log E[X^t + (1-X)^t], t > -pole().
  double log_moment(double t) const {
    if (is_constant_) return log_sum(t * std::log(constant_), t * std::log1p(-constant_));
    const double whole = lgamma(a_ + b_) - lgamma(a_ + b_ + t);
    return whole + log_sum(lgamma(a_ + t) - lgamma(a_), lgamma(b_ + t) - lgamma(b_));
  }

  /// log n, up to where a step to the larger child takes off more than one node.
  double log_steps(double n) const {
    return is_constant_ ? std::log1p(2 * n * std::min(constant_, 1 - constant_)) : std::log(n);
  }

  double pole() const { return is_constant_ ? infinity : std::min(a_, b_); }

 private:
  bool is_constant_ = true;
  double a_ = 0, b_ = 0;
  double constant_;
};

/// The beta law that has mean and variance of the middles of a row's cells; a table of chains gives a wide
/// one.
Fraction fraction_of_row(const Model& model, Size size) {
  const Size row = std::clamp<Size>(size, 1, model.largest_size());
  const auto pmf = split_pmf(model, row);
  const double n = static_cast<double>(pmf.size());
  double mean = 0, square = 0;
  for (std::size_t i = 0; i < pmf.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) / n;
    mean += pmf[i] * x;
    square += pmf[i] * x * x;
  }
  const double both = mean * (1 - mean) / std::max(square - mean * mean, 1e-9) - 1;
  return {mean * both, (1 - mean) * both};
}

/// Over t = 0.001..1000.
template <class F>
double least(F f) {
  double best = infinity;
  for (int i = -60; i <= 60; ++i) best = std::fmin(best, f(std::pow(10, i / 20.0)));
  return best;
}

/// Where the best of the bounds n^(more + t) M(1+t)^h of a tail falls to e^-decay.
double reach(const Fraction& x, double log_n, double decay, double more) {
  return least([&](double t) {
    const double fall = -x.log_moment(1 + t);
    return fall > 0 ? ((more + t) * log_n + decay) / fall : infinity;
  });
}

double fraction_depths(const Fraction& x, double n) {
  const double log_n = x.log_steps(n);
  const double high = std::min(n, reach(x, log_n, negligible_depth, 0));
  const double low = -least([&](double u) {
    const double rise = u < 1 + x.pole() ? x.log_moment(1 - u) : 0;
    return rise > 0 ? (negligible_depth - u * log_n) / rise : 0;
  });
  return high - std::max(0.0, low);
}

double fraction_heights(const Fraction& x, double n) {
  const double log_n = x.log_steps(n);
  const double high = std::min(n, reach(x, log_n, negligible_height, 1));
  // Trees that are nearly chains have low heights too.
  const double low = std::min(n / 3, 0.8 * reach(x, log_n, 0, 1));
  return high - low;
}

/// Of depths and of heights alike where they grow like n^e, and where, at e = 0, they grow like log^2 n; no
/// less than where they grow like log n but no side is without a leaf. Fitted to laws of aldous at n =
/// 250..1000; at e = 1 all nodes are on one path.
double deep_width(double e, double n, double cut) {
  if (e == 1) return 1;
  if (e == 0.5) return 2 * std::sqrt(cut * n) + spread;
  const double log_n = std::log(n);
  const double growth = e == 0 ? log_n : std::expm1(e * log_n) / e;
  return (0.5 + 0.9 * e) * std::pow(cut, 1 - e) * growth + spread;
}

/// depths or heights of a beta fraction.
template <class OfFraction>
double beta_width(const BetaFraction& beta, double n, double cut, OfFraction of_fraction) {
  const double deep = deep_width(depth_exponent(beta), n, cut);
  if (!beta.is_density()) return deep;
  const double values = of_fraction(Fraction(beta.a, beta.b), n) + spread;
  return beta.scatter == Scatter::strings ? std::min(deep, values) : values;
}

/// depths or heights of a model.
template <class OfFraction>
double value_width(const Model& model, Size size, double cut, OfFraction of_fraction) {
  const double n = std::max(2.0, static_cast<double>(size));
  const SplitFraction fraction = model.character().fraction;
  double values = 0;
  if (const auto* beta = std::get_if<BetaFraction>(&fraction))
    values = beta_width(*beta, n, cut, of_fraction);
  else if (const auto* none = std::get_if<NoFraction>(&fraction))
    values = deep_width(none->depth_exponent, n, cut);
  else if (const auto* constant = std::get_if<ConstantFraction>(&fraction))
    values = of_fraction(Fraction(constant->p), n) + spread;
  else if (std::holds_alternative<PerfectFraction>(fraction))
    values = of_fraction(Fraction(0.5), n) + spread;
  else
    values = of_fraction(fraction_of_row(model, size), n) + spread;
  return std::clamp(values, 1.0, n);
}

}  // namespace

double depth_width(const Model& model, Size n) {
  return value_width(model, n, negligible_depth, fraction_depths);
}

double height_width(const Model& model, Size n) {
  return splits_in_one_way(model.character().fraction)
             ? 1
             : value_width(model, n, negligible_height, fraction_heights);
}

}  // namespace ramify
