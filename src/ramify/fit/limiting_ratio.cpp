#include "ramify/fit/limiting_ratio.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ramify/theory/horton_ratio_constant.hpp"
#include "ramify/theory/tokunaga_horton_ratio.hpp"

namespace ramify {
namespace {

constexpr double no_ratio = std::numeric_limits<double>::quiet_NaN();
constexpr double step = 0.02;                     // of a searched number
constexpr double normal_95 = 1.9599639845400545;  // its 97.5 % point

/// NaN where there is none.
double log_ratio(const Family& family, const Point& searched) {
  if (family.given == Given::order) {
    const std::vector<double> values = family.values(searched);
    return std::log(tokunaga_horton_ratio(values[0], values[1]));
  }
  const auto ratio = horton_ratio_constant(family.at(family.values(searched)));
  return ratio ? std::log(ratio->value) : no_ratio;
}

/// The standard error of log R, by its slopes.
double log_error(const FamilyFit& fit, const Point& at) {
  if (fit.covariance.empty()) return no_ratio;
  Point slopes;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Point up = at, down = at;
    up[i] += step;
    down[i] -= step;
    slopes.push_back((log_ratio(*fit.family, up) - log_ratio(*fit.family, down)) / (2 * step));
  }
  double variance = 0;
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = 0; j < at.size(); ++j)
      variance += slopes[i] * slopes[j] * fit.covariance[i * at.size() + j];
  return std::sqrt(variance);
}

bool has_ratio(const FamilyFit& fit) {
  if (fit.family->given == Given::order) return fit.family->of_bi_orders != nullptr;
  if (fit.family->is_simulated()) return false;
  const SplitFraction fraction = fit.family->at(fit.estimates()).character().fraction;
  return std::holds_alternative<BetaFraction>(fraction);
}

}  // namespace

std::optional<FittedParameter> limiting_ratio(const FamilyFit& fit) {
  if (fit.parameters.empty() || fit.at_end) return std::nullopt;
  if (!has_ratio(fit)) return std::nullopt;
  const Point at = fit.family->searched(fit.estimates());
  const double ratio = std::exp(log_ratio(*fit.family, at)), error = log_error(fit, at);
  if (std::isnan(ratio)) return std::nullopt;
  FittedParameter found{"horton_ratio",
                        ratio,
                        ratio * error,
                        ratio * std::exp(-normal_95 * error),
                        ratio * std::exp(normal_95 * error),
                        false,
                        false};
  if (at.size() > 1) return found;
  const FittedParameter& only = fit.parameters.front();
  const double one = std::exp(log_ratio(*fit.family, fit.family->searched(std::vector{only.lower}))),
               other = std::exp(log_ratio(*fit.family, fit.family->searched(std::vector{only.upper})));
  found.lower = std::min(one, other);
  found.upper = std::max(one, other);
  (one < other ? found.lower_open : found.upper_open) = only.lower_open;
  (one < other ? found.upper_open : found.lower_open) = only.upper_open;
  return found;
}

}  // namespace ramify
