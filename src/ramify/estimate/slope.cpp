#include "ramify/estimate/slope.hpp"

#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/estimate/centred_slope.hpp"

namespace ramify {

Slope fit_slope(const std::vector<SizedMean>& points) {
  RAMIFY_EXPECTS(points.size() >= 2);
  const auto weight = [](const SizedMean& point) {
    return 1 / (point.standard_error * point.standard_error);
  };
  double weights = 0, mean_log_n = 0;
  for (const auto& point : points) {
    weights += weight(point);
    mean_log_n += weight(point) * std::log(point.n);
  }
  CentredSlope slope(mean_log_n / weights);
  for (const auto& point : points) slope.add(std::log(point.n), point.mean, weight(point));
  return {slope.value(), 1 / std::sqrt(slope.weight()), points.front().n, points.back().n};
}

GrowthConstant growth_constant(const std::vector<SizedMean>& points) {
  RAMIFY_EXPECTS(points.size() >= 4);
  const auto half = static_cast<std::ptrdiff_t>((points.size() + 1) / 2);
  const auto quarter = static_cast<std::ptrdiff_t>(points.size() / 4);
  const Slope upper = fit_slope({points.end() - half, points.end()});
  const Slope middle = fit_slope({points.end() - half - quarter, points.end() - quarter});
  return {upper, upper.value - middle.value, std::hypot(upper.standard_error, middle.standard_error)};
}

}  // namespace ramify
