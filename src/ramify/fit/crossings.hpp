#pragma once

#include <span>
#include <vector>

#include "ramify/fit/response.hpp"

namespace ramify {

/// Two neighbouring values of p, the mean ratio surely above the target at one and below it at the other.
struct Bracket {
  double low;
  double high;
  double guess;  ///< where a straight line between them crosses
  double slope;  ///< of that line, in p
};

/// Where the curve of an estimator's mean crosses a target, as far as its points can tell.
struct CrossingScan {
  std::vector<Bracket> brackets;  ///< ascending
  std::vector<double>
      undecided;  ///< points within the noise of the target that no bracket explains: grow more trees there
  std::vector<double>
      vertices;  ///< p between points, where a hump or hollow may reach the target unseen: put a point there
  bool any_decided = false;  ///< some point is clear of the target
};

/// Looks for crossings along the points, telling them from noise.
///
/// A point counts as above or below only where its mean is 3.5 standard errors clear of the target (1 wrong
/// in 4,000 even for a point on the target); a crossing is a change between decided points. A lone undecided
/// point between opposite sides is a crossing like any other; runs of them, and those that touch the target
/// from one side, are handed back.
/// @param points  ascending p
CrossingScan scan_crossings(std::span<const ResponsePoint> points, RatioEstimator estimator, double target);

}  // namespace ramify
