#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "ramify/optimise/objective.hpp"

namespace ramify {

/// What is squared and summed: so many residuals, functions of a few parameters.
///
/// evaluate(at, residuals, jacobian) writes the residuals and, where it is not null, their derivatives,
/// residual by residual (row by row); false where they are not finite.
struct Residuals {
  std::function<bool(std::span<const double> at, std::span<double> residuals, double* jacobian)> evaluate;
  std::size_t count;
};

/// Where a sum of squares is least.
struct LeastSquares {
  Point at;
  double sum_of_squares;
  /// (J'J)^-1, row by row: the covariance of the estimates where residuals are in units of their standard
  /// errors, independent and normal, and the model is nearly linear over it. Empty where J'J has no inverse.
  std::vector<double> covariance;
  bool converged;

  double variance(std::size_t i) const { return covariance[i * at.size() + i]; }
};

/// Weighted non-linear least squares: Ceres's Levenberg and Marquardt by QR, then Gauss and Newton's steps
/// until they no longer shrink, which takes the last digits out of the sum's flat bottom; ceres::Covariance
/// by SVD. Held against the certified problems of NIST (tests/unit/optimise_nist_test.cpp).
LeastSquares least_squares(const Residuals& residuals, const Point& start);

}  // namespace ramify
