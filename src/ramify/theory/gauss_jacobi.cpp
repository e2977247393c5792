#include "ramify/theory/gauss_jacobi.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

// The recurrence of the Jacobi polynomials for (1-t)^beta (1+t)^alpha on (-1,1), t = 2x-1. The first
// coefficients are written apart: the general ones are 0/0 where alpha + beta is 0 or -1.

Eigen::VectorXd diagonal(int points, double alpha, double beta) {
  Eigen::VectorXd centres(points);
  centres[0] = (alpha - beta) / (alpha + beta + 2);
  for (int k = 1; k < points; ++k) {
    const double s = 2 * k + alpha + beta;
    centres[k] = (alpha - beta) * (alpha + beta) / (s * (s + 2));
  }
  return centres;
}

Eigen::VectorXd off_diagonal(int points, double alpha, double beta) {
  Eigen::VectorXd squares(points - 1);
  for (int k = 1; k < points; ++k) {
    const double s = 2 * k + alpha + beta;
    const double common = 4 * (k + alpha) * (k + beta) / (s * s * (s + 1));
    squares[k - 1] = k == 1 ? common : common * k * (k + alpha + beta) / (s - 1);
  }
  return squares.cwiseSqrt();
}

}  // namespace

Quadrature gauss_jacobi(int points, double alpha, double beta) {
  RAMIFY_EXPECTS(points >= 2 && alpha > -1 && beta > -1);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal(points, alpha, beta), off_diagonal(points, alpha, beta));
  Quadrature rule;
  for (int i = 0; i < points; ++i) {
    rule.nodes.push_back((solver.eigenvalues()[i] + 1) / 2);
    rule.weights.push_back(std::pow(solver.eigenvectors()(0, i), 2));
  }
  return rule;
}

}  // namespace ramify
