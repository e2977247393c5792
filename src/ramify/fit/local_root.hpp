#pragma once

#include <span>

namespace ramify {

/// A noisy value of a curve.
struct CurveSample {
  double p;
  double mean;
  double standard_error;  ///< > 0
};

/// Where a noisy curve takes a value, with the error of that place.
struct LocalRoot {
  double p;
  double standard_error;  ///< of p, from the noise of the samples alone
  double slope;           ///< of the curve at p
  double misfit;   ///< P(chi-square of a right model >= the one found): small where a parabola does not fit
  bool converged;  ///< the solver did, and the covariance exists
};

/// Solves R(p*) = target by weighted non-linear least squares (Ceres, automatic derivatives) of
///   R(p) = target + c1 (p - p*) + c2 (p - p*)^2,   weights 1/standard_error,
/// in which p* is itself a parameter, so that ceres::Covariance gives its standard error.
///
/// @param samples  four at least, of different p, near the root
/// @param p, slope  where to start
LocalRoot solve_local_root(std::span<const CurveSample> samples, double target, double p, double slope);

}  // namespace ramify
