#include "ramify/fit/accepted_set.hpp"

#include <algorithm>
#include <optional>

namespace ramify {
namespace {

/// The part of [0, 1] on which the line from a to b is >= 0.
std::optional<PInterval> nonnegative_part(double a, double b) {
  if (a < 0 && b < 0) return std::nullopt;
  if (a >= 0 && b >= 0) return PInterval{0, 1};
  const double zero = a / (a - b);
  return a >= 0 ? PInterval{0, zero} : PInterval{zero, 1};
}

/// The accepted part between two neighbouring points, in p.
std::optional<PInterval> accepted_part(const ResponsePoint& left, const ResponsePoint& right,
                                       RatioEstimator estimator, double observed) {
  // Quantiles of ratios that take few values coincide with the observed one up to rounding.
  const double slack = 1e-12 * observed;
  const auto above_low =
      nonnegative_part(observed - left[estimator].low + slack, observed - right[estimator].low + slack);
  const auto below_high =
      nonnegative_part(left[estimator].high - observed + slack, right[estimator].high - observed + slack);
  if (!above_low || !below_high) return std::nullopt;
  const double from = std::max(above_low->low, below_high->low),
               to = std::min(above_low->high, below_high->high);
  if (from > to) return std::nullopt;
  const double width = right.p - left.p;
  return PInterval{left.p + from * width, to == 1 ? right.p : left.p + to * width};
}

}  // namespace

std::vector<PInterval> accepted_set(std::span<const ResponsePoint> points, RatioEstimator estimator,
                                    double observed) {
  std::vector<PInterval> pieces;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto part = accepted_part(points[i - 1], points[i], estimator, observed);
    if (!part) continue;
    if (!pieces.empty() && pieces.back().high >= part->low) {
      pieces.back().high = part->high;
    } else {
      pieces.push_back(*part);
    }
  }
  return pieces;
}

}  // namespace ramify
