#pragma once

#include <vector>

namespace ramify {

/// A measured mean at one size.
struct SizedMean {
  double n;
  double mean;
  double standard_error;  ///< > 0
};

/// The slope of a mean against log n.
struct Slope {
  double value;
  double standard_error;  ///< from the means' errors alone, not from their scatter about the line
  double smallest_n;
  double largest_n;
};

/// Weighted least squares of mean on log n, weights 1/se^2. At least two different sizes. O(points).
Slope fit_slope(const std::vector<SizedMean>& points);

/// A growth constant lim mean / log n by slopes: constants of order one in the mean, which spoil the raw
/// quotient, drop out.
struct GrowthConstant {
  Slope slope;         ///< over the upper half of the sizes
  double drift;        ///< that slope minus the one over the middle half: what is left of finite-size bias
  double drift_error;  ///< standard error of the drift, the two taken as independent (they share sizes: an
                       ///< upper bound)
};

/// Slopes over the upper and over the middle half of the points (ascending n). At least four points.
GrowthConstant growth_constant(const std::vector<SizedMean>& points);

}  // namespace ramify
