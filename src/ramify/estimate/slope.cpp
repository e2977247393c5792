#include "ramify/estimate/slope.hpp"

#include <cmath>

#include "ramify/core/contract.hpp"

namespace ramify {

Slope fit_slope(const std::vector<SizedMean>& points) {
  RAMIFY_EXPECTS(points.size() >= 2);
  double weights = 0, x_mean = 0;
  for (const auto& point : points) {
    const double weight = 1 / (point.standard_error * point.standard_error);
    weights += weight;
    x_mean += weight * std::log(point.n);
  }
  x_mean /= weights;
  double sxx = 0, sxy = 0;
  for (const auto& point : points) {
    const double weight = 1 / (point.standard_error * point.standard_error);
    const double x = std::log(point.n) - x_mean;
    sxx += weight * x * x;
    sxy += weight * x * point.mean;
  }
  return {sxy / sxx, 1 / std::sqrt(sxx), points.front().n, points.back().n};
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
