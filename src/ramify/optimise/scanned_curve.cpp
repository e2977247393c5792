#include "ramify/optimise/scanned_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <boost/math/tools/minima.hpp>

#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/optimise/root_between.hpp"

namespace ramify {
namespace {

/// What rounding leaves of two values that are one.
constexpr double same = 1e-13;

/// 1 above, -1 below, 0 where the values are one.
int side(double value, double target) {
  if (std::abs(value - target) <= same * std::abs(target)) return 0;
  return value > target ? 1 : -1;
}

}  // namespace

ScannedCurve::ScannedCurve(Function function, const std::vector<double>& grid, const ScanEffort& effort)
    : function_(std::move(function)), cancellation_(effort.cancellation) {
  points_.resize(grid.size());
  parallel_for(grid.size(), effort.threads,
               [&](std::size_t i, unsigned) { points_[i] = {grid[i], value(grid[i])}; });
  std::erase_if(points_, [](const ScannedCurve::Point& point) { return std::isnan(point.y); });
  add_extrema();
}

ScannedCurve::Point ScannedCurve::lowest() const {
  return *std::ranges::min_element(points_, {}, &ScannedCurve::Point::y);
}

ScannedCurve::Point ScannedCurve::highest() const {
  return *std::ranges::max_element(points_, {}, &ScannedCurve::Point::y);
}

double ScannedCurve::value(double x) const {
  if (cancellation_->requested()) throw Interrupted();
  return function_(x);
}

void ScannedCurve::add_extrema() {
  std::vector<ScannedCurve::Point> extrema;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const int before = side(points_[i].y, points_[i - 1].y), after = side(points_[i].y, points_[i + 1].y);
    if (before * after <= 0) continue;
    // The value is stationary there: half the digits of x give all of it.
    constexpr int half_the_digits = std::numeric_limits<double>::digits / 2;
    std::uintmax_t calls = 60;
    const auto [x, y] =
        boost::math::tools::brent_find_minima([&](double at) { return -before * value(at); },
                                              points_[i - 1].x, points_[i + 1].x, half_the_digits, calls);
    extrema.push_back({x, -before * y});
  }
  points_.insert(points_.end(), extrema.begin(), extrema.end());
  std::ranges::sort(points_, {}, &ScannedCurve::Point::x);
}

std::vector<double> ScannedCurve::solutions(double y) const {
  std::vector<double> found;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const int here = side(points_[i].y, y);
    if (here == 0) {
      found.push_back(points_[i].x);
      const std::size_t first = i;
      while (i + 1 < points_.size() && side(points_[i + 1].y, y) == 0) ++i;
      if (i > first) found.push_back(points_[i].x);
    } else if (i > 0 && here * side(points_[i - 1].y, y) < 0) {
      found.push_back(root_between([&](double x) { return value(x) - y; }, points_[i - 1].x, points_[i].x));
    }
  }
  return found;
}

}  // namespace ramify
