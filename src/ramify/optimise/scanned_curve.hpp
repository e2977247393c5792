#pragma once

#include <functional>
#include <vector>

#include "ramify/core/cancellation.hpp"

namespace ramify {

/// How a curve is scanned: on how many threads, which no result depends on, and until when.
struct ScanEffort {
  unsigned threads;
  const Cancellation* cancellation;
};

/// A smooth function on a stretch, known at points so close that it rises or falls between neighbours: those
/// of a grid, and every extremum that three of them show.
class ScannedCurve {
 public:
  using Function = std::function<double(double x)>;

  struct Point {
    double x;
    double y;
  };

  /// @param function  called from several threads; NaN where it has no value, which is no point of the curve
  /// @param grid      ascending
  /// Throws Interrupted. Cost: a call for each point of the grid, some 15 for each extremum.
  ScannedCurve(Function function, const std::vector<double>& grid, const ScanEffort& effort);

  /// Ascending in x; may be empty.
  const std::vector<Point>& points() const { return points_; }
  /// Of a curve with points.
  Point lowest() const;
  Point highest() const;

  /// Every x with f(x) = y, ascending; where the curve runs along y, within 1e-13 of it, both ends of the
  /// run.
  std::vector<double> solutions(double y) const;

 private:
  double value(double x) const;
  void add_extrema();

  Function function_;
  const Cancellation* cancellation_;
  std::vector<Point> points_;
};

}  // namespace ramify
