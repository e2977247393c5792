#pragma once

#include "ramify/compare/verdict.hpp"
#include "ramify/estimate/slope.hpp"

namespace ramify {

/// A closed interval.
struct Interval {
  double lower;
  double upper;
};

/// Two-sided 99 % of a normal law: the tables have some twenty rows.
inline constexpr double interval_sigmas = 2.5758293035489004;

/// estimate +- 2.576 standard errors.
Interval sampling_interval(double estimate, double standard_error);

/// How the mean of a statistic approaches its growth law.
enum class Approach {
  settles,  ///< mean = c log n + constant + O(1/n), at phase-matched sizes where it oscillates: slopes decide
  drifts,   ///< a slower term is left (log log n, drifting thresholds): a slope off the band decides nothing
};

/// The sampling interval of the slope, stretched by the drift in the direction the slope is moving: a slope
/// that changed by d over a quarter of the grid is not believed to stay put beyond it. Where the law says
/// that the slope settles, only the part of d that sampling error does not explain counts.
Interval growth_interval(const GrowthConstant& growth, Approach approach);

/// reproduced where the interval lies inside theory +- tolerance, refuted where it lies wholly outside, else
/// inconclusive. A pass is thus an interval inside a stated tolerance, never a failure to reject.
Outcome judge(const Interval& interval, double theory, double tolerance);

}  // namespace ramify
