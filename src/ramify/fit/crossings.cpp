#include "ramify/fit/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ramify {
namespace {

constexpr double clear_errors = 3.5;
// A ratio that is the same in every tree is still rounded.
constexpr double rounding = 1e-12;

/// The curve of one estimator against one target.
class TargetCurve {
 public:
  TargetCurve(std::span<const ResponsePoint> points, RatioEstimator estimator, double target)
      : points_(points), estimator_(estimator), target_(target) {}

  std::size_t size() const { return points_.size(); }
  double p(std::size_t i) const { return points_[i].p; }
  double excess(std::size_t i) const { return points_[i][estimator_].mean - target_; }
  double noise(std::size_t i) const {
    return std::max(clear_errors * points_[i][estimator_].standard_error, rounding * target_);
  }

  /// 1 above, -1 below, 0 within the noise.
  int side(std::size_t i) const {
    if (std::abs(excess(i)) <= noise(i)) return 0;
    return excess(i) > 0 ? 1 : -1;
  }

  Bracket bracket(std::size_t i, std::size_t j) const {
    const double slope = (excess(j) - excess(i)) / (p(j) - p(i));
    return {p(i), p(j), p(i) - excess(i) / slope, slope};
  }

 private:
  std::span<const ResponsePoint> points_;
  RatioEstimator estimator_;
  double target_;
};

/// The vertex of the parabola through three points, where it lies between the outer two and within reach of
/// the target while the points themselves stay on one side.
std::optional<double> hidden_vertex(const TargetCurve& curve, std::size_t i) {
  const int side = curve.side(i);
  if (side == 0 || curve.side(i - 1) != side || curve.side(i + 1) != side) return std::nullopt;
  const double left = std::log(curve.p(i - 1) / curve.p(i)), right = std::log(curve.p(i + 1) / curve.p(i));
  const double to_left = (curve.excess(i - 1) - curve.excess(i)) / left;
  const double to_right = (curve.excess(i + 1) - curve.excess(i)) / right;
  const double curvature = (to_right - to_left) / (right - left);
  const double tangent = to_left - curvature * left;
  if (curvature * side <= 0) return std::nullopt;
  const double place = -tangent / (2 * curvature);
  if (place <= left || place >= right) return std::nullopt;
  const double height = curve.excess(i) - tangent * tangent / (4 * curvature);
  if (height * side > curve.noise(i)) return std::nullopt;
  // A vertex on top of a point says nothing new.
  const double nearest = std::min({std::abs(place), std::abs(place - left), std::abs(place - right)});
  if (nearest < (right - left) / 16) return std::nullopt;
  return curve.p(i) * std::exp(place);
}

/// Points first..last-1 are undecided; the neighbours on both sides are decided or missing.
void close_run(const TargetCurve& curve, std::size_t first, std::size_t last, CrossingScan& scan) {
  const int before = first > 0 ? curve.side(first - 1) : 0;
  const int after = last < curve.size() ? curve.side(last) : 0;
  const bool plain_crossing = before * after < 0 && last - first == 1;
  if (plain_crossing) return;
  for (std::size_t i = first; i < last; ++i) scan.undecided.push_back(curve.p(i));
}

}  // namespace

CrossingScan scan_crossings(std::span<const ResponsePoint> points, RatioEstimator estimator, double target) {
  const TargetCurve curve(points, estimator, target);
  CrossingScan scan;
  std::optional<std::size_t> decided;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (curve.side(i) == 0) continue;
    const std::size_t run = decided ? *decided + 1 : 0;
    if (run < i) close_run(curve, run, i, scan);
    if (decided && curve.side(*decided) != curve.side(i)) scan.brackets.push_back(curve.bracket(*decided, i));
    decided = i;
  }
  const std::size_t tail = decided ? *decided + 1 : 0;
  if (tail < curve.size()) close_run(curve, tail, curve.size(), scan);
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    if (const auto vertex = hidden_vertex(curve, i)) scan.vertices.push_back(*vertex);
  }
  scan.any_decided = decided.has_value();
  return scan;
}

}  // namespace ramify
