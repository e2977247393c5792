#pragma once

#include <span>
#include <vector>

#include "ramify/optimise/objective.hpp"

namespace ramify {

/// Where a function is smallest among its neighbours.
struct Minimum {
  Point at;
  double value;
  std::vector<double> curvature;  ///< second derivatives, row by row; central differences of the gradient
  bool converged;  ///< the gradient vanishes, and the curvature is positive, or it points out of the box at
                   ///< an end
  bool at_end;     ///< of the box: the function falls towards it

  double second(std::size_t i, std::size_t j) const { return curvature[i * at.size() + j]; }

  /// The inverse of the curvature, row by row: of a negative log-likelihood the covariance of the estimates
  /// (Fisher). Empty where it has none.
  std::vector<double> covariance() const;
};

/// The minimum below `start`: Ceres's BFGS (GradientProblem), then Newton's steps until they are below 1e-7,
/// so that what is left is their square. Cost: some 30 evaluations of a parameter.
/// @param start  in the box, where the function has a value
Minimum minimise(const Objective& objective, const Point& start);

/// The same from a start that is all but there: Newton's steps alone, and the whole search where they do not
/// converge. Cost: some 4 evaluations a parameter and step.
Minimum minimise_near(const Objective& objective, const Point& start);

/// Whether two minima are one that was found twice.
bool are_same(const Minimum& a, const Minimum& b);

/// The minima below several starts, the lowest first; those that two starts find are listed
/// once. Starts where the function has no value are passed over.
std::vector<Minimum> minima(const Objective& objective, std::span<const Point> starts);

}  // namespace ramify
