#pragma once

#include <span>
#include <vector>

#include "ramify/fit/response.hpp"

namespace ramify {

/// Values of p, both ends included.
struct PInterval {
  double low;
  double high;
};

/// All p in the range of the points whose central 95 % of one tree's ratio contains the observed one: a
/// confidence set for p from one measured tree (Neyman's construction).
///
/// The quantile curves are drawn straight between the points. The set need not be one interval: its pieces,
/// ascending.
/// @param points  ascending p
std::vector<PInterval> accepted_set(std::span<const ResponsePoint> points, RatioEstimator estimator,
                                    double observed);

}  // namespace ramify
