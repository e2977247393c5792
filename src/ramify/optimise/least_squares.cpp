#include "ramify/optimise/least_squares.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include "ramify/core/contract.hpp"
#include "ramify/optimise/quiet_ceres.hpp"

namespace ramify {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One block of all residuals.
class Block final : public ceres::CostFunction {
 public:
  Block(const Residuals& residuals, std::size_t parameters) : residuals_(residuals) {
    mutable_parameter_block_sizes()->push_back(static_cast<int>(parameters));
    set_num_residuals(static_cast<int>(residuals.count));
  }

  bool Evaluate(double const* const* at, double* residuals, double** jacobians) const override {
    double* jacobian = jacobians == nullptr ? nullptr : jacobians[0];
    const auto parameters = static_cast<std::size_t>(parameter_block_sizes()[0]);
    return residuals_.evaluate({at[0], parameters}, {residuals, residuals_.count}, jacobian);
  }

 private:
  const Residuals& residuals_;
};

ceres::Solver::Options solver_options(ceres::MinimizerType type) {
  ceres::Solver::Options options;
  options.minimizer_type = type;
  options.line_search_direction_type = ceres::BFGS;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 2000;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  return options;
}

/// Residuals and derivatives at a point.
struct Linearised {
  VectorXd residuals;
  RowMatrix jacobian;
  bool exists;

  Linearised(const Residuals& of, const Point& at)
      : residuals(static_cast<Index>(of.count)),
        jacobian(static_cast<Index>(of.count), static_cast<Index>(at.size())),
        exists(of.evaluate(at, {residuals.data(), of.count}, jacobian.data()) && residuals.allFinite() &&
               jacobian.allFinite()) {}

  /// In units of the parameters' own scales, so that QR tells what is singular.
  VectorXd step() const {
    const VectorXd scales = jacobian.colwise().norm();
    if (scales.minCoeff() <= 0) return VectorXd::Zero(jacobian.cols());
    const RowMatrix scaled = jacobian * scales.cwiseInverse().asDiagonal();
    return scaled.colPivHouseholderQr().solve(-residuals).cwiseQuotient(scales);
  }
};

/// Gauss and Newton's steps while each is clearly shorter than the one before, in units of the parameters.
void polish(const Residuals& residuals, Point& at) {
  constexpr int steps = 200;
  constexpr double shorter = 0.9;
  double size = 1e-2;
  for (int i = 0; i < steps; ++i) {
    const Linearised here(residuals, at);
    if (!here.exists) return;
    const VectorXd step = here.step();
    double next = 0;
    for (std::size_t k = 0; k < at.size(); ++k)
      next = std::max(next, std::abs(step[static_cast<Index>(k)]) / std::max(std::abs(at[k]), 1e-300));
    if (!(next <= shorter * size)) return;
    size = next;
    for (std::size_t k = 0; k < at.size(); ++k) at[k] += step[static_cast<Index>(k)];
  }
}

std::vector<double> covariance_of(ceres::Problem& problem, const Point& at) {
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::DENSE_SVD;
  ceres::Covariance covariance(options);
  const std::vector<std::pair<const double*, const double*>> blocks{{at.data(), at.data()}};
  std::vector<double> found(at.size() * at.size());
  if (!covariance.Compute(blocks, &problem) ||
      !covariance.GetCovarianceBlock(at.data(), at.data(), found.data()))
    found.clear();
  return found;
}

/// One search, polished.
LeastSquares searched(const Residuals& residuals, const Point& start, ceres::MinimizerType type) {
  Point at = start;
  ceres::Problem problem;
  problem.AddResidualBlock(new Block(residuals, at.size()), nullptr, at.data());
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(type), &problem, &summary);
  polish(residuals, at);
  std::vector<double> rest(residuals.count);
  const bool exists = residuals.evaluate(at, rest, nullptr);
  double sum = 0;
  for (const double residual : rest) sum += residual * residual;
  std::vector<double> covariance = covariance_of(problem, at);
  return {at, sum, std::move(covariance), exists && summary.termination_type == ceres::CONVERGENCE};
}

}  // namespace

LeastSquares least_squares(const Residuals& residuals, const Point& start) {
  RAMIFY_EXPECTS(residuals.count >= start.size());
  quiet_ceres();
  LeastSquares found = searched(residuals, start, ceres::TRUST_REGION);
  if (found.converged && !found.covariance.empty()) return found;
  LeastSquares other = searched(residuals, start, ceres::LINE_SEARCH);
  other = searched(residuals, other.at, ceres::TRUST_REGION);
  return other.converged && other.sum_of_squares < found.sum_of_squares ? other : found;
}

}  // namespace ramify
