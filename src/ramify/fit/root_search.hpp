#pragma once

#include <cstdint>
#include <vector>

#include "ramify/fit/ratio_curve.hpp"
#include "ramify/fit/response.hpp"

namespace ramify {

/// Trees to grow at a point of the grid, and at each of the seven points around a root.
struct SearchEffort {
  std::uint64_t grid_trees;
  std::uint64_t root_trees;
};

/// A p at which trees have the target as their expected ratio.
struct CurveRoot {
  double p;
  double standard_error;  ///< Monte Carlo error of p
  bool converged;
};

struct RootSearch {
  std::vector<CurveRoot> roots;  ///< ascending p
  std::vector<double>
      undecided;  ///< p at which the curve may or may not touch the target: its noise hides it
  bool flat;      ///< no point of the curve differs from the target: the data say nothing of p
};

/// Every p in [ResponseSurface::lowest_p, 1/2] at which the estimator's expectation is the target.
///
/// Scans the curve for crossings (crossings.hpp); grows up to 16 times as many trees where noise hides what
/// happens; then, in every bracket, seven points of root_trees trees within a grid step of the root and
/// solve_local_root. Where a parabola does not fit them the design is halved; a root that leaves it is
/// followed.
/// @param curve  the grid's points, at least; points grown here are added
RootSearch find_roots(const ResponseSurface& surface, RatioCurve& curve, RatioEstimator estimator,
                      double target, const SearchEffort& effort);

}  // namespace ramify
