#include "ramify/estimate/limit_slope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double unknown_bound = std::numeric_limits<double>::infinity();

/// A slope between two points and what their errors leave of it.
struct Step {
  double slope, error;
};

Step step_between(const KnownPoint& a, const KnownPoint& b) {
  return {(b.y - a.y) / (b.x - a.x), (a.error + b.error) / (b.x - a.x)};
}

/// 1, x^(-1/2), x^(-1), ... after x and log x.
double term(std::size_t number, double x) {
  if (number == 0) return x;
  if (number == 1) return std::log(x);
  return std::pow(x, -0.5 * static_cast<double>(number - 2));
}

/// The coefficient of x in the least-squares fit of so many terms, and what the errors of the points leave of
/// it.
Step fitted_slope(const std::vector<KnownPoint>& points, std::size_t terms) {
  const auto rows = static_cast<Eigen::Index>(points.size()), columns = static_cast<Eigen::Index>(terms);
  Eigen::MatrixXd design(rows, columns);
  Eigen::VectorXd y(rows), errors(rows);
  const double scale = points.back().x;  // x in (0,1]: the terms stay comparable
  for (Eigen::Index i = 0; i < rows; ++i) {
    const KnownPoint& point = points[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < columns; ++j)
      design(i, j) = term(static_cast<std::size_t>(j), point.x / scale);
    y(i) = point.y;
    errors(i) = point.error;
  }
  const Eigen::MatrixXd inverse = design.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::RowVectorXd weights = inverse.row(0);
  constexpr double rounding = 4e-16;
  const double left = weights.cwiseAbs().dot(errors + rounding * y.cwiseAbs());
  return {weights.dot(y) / scale, left / scale};
}

}  // namespace

LimitSlope settling_slope(const std::vector<KnownPoint>& points) {
  constexpr std::size_t fewest = 6;
  RAMIFY_EXPECTS(points.size() >= fewest);
  std::vector<Step> steps;
  for (std::size_t i = 1; i < points.size(); ++i) steps.push_back(step_between(points[i - 1], points[i]));
  const Step last = steps.back();
  const auto change = [&](std::size_t back) {
    const std::size_t i = steps.size() - 1 - back;
    return std::abs(steps[i].slope - steps[i - 1].slope);
  };
  const double noise = 2 * last.error;
  if (change(0) <= noise && change(1) <= noise) return {last.slope, last.error + noise};
  // Over so many changes no oscillation falls all the time; what errors leave of one is no news of its rate.
  const std::size_t looked_at = std::min<std::size_t>(steps.size() - 2, 4);
  double rate = 0;
  for (std::size_t back = 0; back < looked_at; ++back)
    rate = std::max(rate, change(back) / std::max(change(back + 1), noise));
  constexpr double slowest = 0.9, least = 0.5;
  if (!(rate <= slowest)) return {last.slope, unknown_bound};
  const double tail = std::max(rate, least);
  return {last.slope, last.error + (change(0) + noise) * tail / (1 - tail)};
}

LimitSlope drifting_slope(const std::vector<KnownPoint>& points) {
  constexpr std::size_t fewest = 4, most = 8;
  constexpr double safety = 3;
  RAMIFY_EXPECTS(points.size() >= most + 2 && points.front().x > 0);
  std::vector<Step> fits;
  for (std::size_t terms = fewest - 2; terms <= most; ++terms) fits.push_back(fitted_slope(points, terms));
  LimitSlope best{fits.back().slope, unknown_bound};
  for (std::size_t i = 2; i < fits.size(); ++i) {
    const double spread =
        std::abs(fits[i].slope - fits[i - 1].slope) + std::abs(fits[i - 1].slope - fits[i - 2].slope);
    const double bound = safety * spread + fits[i].error;
    if (bound < best.bound) best = {fits[i].slope, bound};
  }
  return best;
}

}  // namespace ramify
