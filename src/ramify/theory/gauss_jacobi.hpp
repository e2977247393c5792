#pragma once

#include <vector>

namespace ramify {

/// A quadrature rule: sum over i of weights[i] g(nodes[i]).
struct Quadrature {
  std::vector<double> nodes;    ///< rising
  std::vector<double> weights;  ///< positive, sum 1
};

/// Gauss's rule for E g(X), X ~ beta(alpha+1, beta+1), i.e. for the weight x^alpha (1-x)^beta on (0,1).
///
/// Exact for polynomials of degree < 2 points. Its nodes follow the density: a peak needs no more of them
/// than a flat weight.
/// @param alpha,beta  > -1
/// Cost: O(points^2). Golub, Welsch 1969: eigenvalues of the Jacobi matrix of the orthogonal polynomials.
Quadrature gauss_jacobi(int points, double alpha, double beta);

}  // namespace ramify
