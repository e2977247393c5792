#pragma once

#include <vector>

namespace ramify {

/// A value y at x, known up to an error.
struct KnownPoint {
  double x, y, error;
};

/// A slope in the limit of large x, extrapolated: no theorem says that it lies within the bound. The bound is
/// infinite where the points do not tell.
struct LimitSlope {
  double value, bound;
};

/// lim dy/dx of a series whose slopes settle at a geometric rate: y = c x + constant + O(r^x).
///
/// The last slope; its bound is what the errors of its two points leave, and the geometric tail that the last
/// changes of the slope promise, taken no shorter than the last change itself. Infinite where one of
/// the last four changes does not fall by a tenth, as of a series that drifts or oscillates.
/// @param points  ascending x in equal steps, six or more
LimitSlope settling_slope(const std::vector<KnownPoint>& points);

/// lim dy/dx of a series that drifts as pulled fronts do: y = c x + a log x + b + e_1 x^(-1/2) + e_2 x^(-1) +
/// ...
///
/// Least squares with four to eight of these terms; of every number of terms the bound is three times the
/// changes of c from one and two terms fewer, and what the errors of the points leave of c. The number with
/// the least bound is taken. Ebert, van Saarloos 2000 have the terms of a front. Of 140 ladders with known
/// limits (docs/theory/limits.md) the worst misses by 0.61 of its bound.
/// @param points  ascending x > 0, ten or more, the last x three times the first or more
LimitSlope drifting_slope(const std::vector<KnownPoint>& points);

}  // namespace ramify
