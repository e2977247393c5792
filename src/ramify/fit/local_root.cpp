#include "ramify/fit/local_root.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <boost/math/special_functions/gamma.hpp>
#include <ceres/ceres.h>
#include <glog/logging.h>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

// The parameters are of order one: t* = (p* - centre) / scale, and the slope and curvature in t.
struct Residual {
  double t;
  double excess;
  double standard_error;

  template <class T>
  bool operator()(const T* parameters, T* residual) const {
    const T distance = t - parameters[0];
    residual[0] = (parameters[1] * distance + parameters[2] * distance * distance - excess) / standard_error;
    return true;
  }
};

/// What Ceres has to say is in the result; lines of its own on standard error are none of ours.
void silence_ceres() {
  FLAGS_minloglevel = google::GLOG_FATAL;
}

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-15;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-13;
  return options;
}

}  // namespace

LocalRoot solve_local_root(std::span<const CurveSample> samples, double target, double p, double slope) {
  RAMIFY_EXPECTS(samples.size() >= 4);
  silence_ceres();
  double scale = 0;
  for (const CurveSample& sample : samples) scale = std::max(scale, std::abs(sample.p - p));
  std::array<double, 3> parameters{0, slope * scale, 0};
  ceres::Problem problem;
  for (const CurveSample& sample : samples) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residual, 1, 3>(new Residual{
                                 (sample.p - p) / scale, sample.mean - target, sample.standard_error}),
                             nullptr, parameters.data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(), &problem, &summary);
  ceres::Covariance::Options covariance_options;
  covariance_options.algorithm_type = ceres::DENSE_SVD;
  ceres::Covariance covariance(covariance_options);
  const std::vector<std::pair<const double*, const double*>> blocks{{parameters.data(), parameters.data()}};
  std::array<double, 9> variances{};
  const bool has_covariance =
      summary.termination_type == ceres::CONVERGENCE && covariance.Compute(blocks, &problem) &&
      covariance.GetCovarianceBlock(parameters.data(), parameters.data(), variances.data());
  const double degrees = static_cast<double>(samples.size()) - 3;
  // Ceres minimises half the sum of squares: half of chi-square.
  const double misfit = boost::math::gamma_q(degrees / 2, summary.final_cost);
  return {p + scale * parameters[0], scale * std::sqrt(variances[0]), parameters[1] / scale, misfit,
          has_covariance};
}

}  // namespace ramify
