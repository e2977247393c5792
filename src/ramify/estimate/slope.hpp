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
  double standard_error;   ///< from the means' errors alone, not from their scatter about the line
  double smallest_n;
  double largest_n;
};

/// Weighted least squares of mean on log n, weights 1/se^2. At least two different sizes. O(points).
Slope fit_slope(const std::vector<SizedMean>& points);

/// A growth constant lim mean / log n by slopes: constants of order one in the mean, which spoil the raw
/// quotient, drop out.
struct GrowthConstant {
  Slope slope;   ///< over the upper part of the sizes
  double drift;  ///< that slope minus the one over the part just below: what is left of finite-size bias
};

/// Slopes over the upper and the lower part of the points (ascending n), each of at least two sizes; the parts share the
/// middle point when the number is odd. At least three points.
GrowthConstant growth_constant(const std::vector<SizedMean>& points);

}  // namespace ramify
