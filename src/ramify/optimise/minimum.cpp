#include "ramify/optimise/minimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include "ramify/core/contract.hpp"
#include "ramify/optimise/quiet_ceres.hpp"

namespace ramify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double near_an_end = 1e-6;  // of a box, in units of its parameters
constexpr int newton_steps = 20;
constexpr double small_step = 1e-7;  // the next would be lost in rounding

std::span<const double> span_of(const VectorXd& at) {
  return {at.data(), static_cast<std::size_t>(at.size())};
}

/// The point of the box that a point beyond an end is the mirror image of: a line search that leaves the box
/// finds the function continued, and comes back.
Point reflected(const Objective& objective, std::span<const double> at, std::vector<bool>& turned) {
  Point inside(at.begin(), at.end());
  turned.assign(at.size(), false);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const double low = objective.low[i], high = objective.high[i];
    turned[i] = inside[i] < low || inside[i] > high;
    if (inside[i] < low) inside[i] = std::min(2 * low - inside[i], high);
    if (inside[i] > high) inside[i] = std::max(2 * high - inside[i], low);
  }
  return inside;
}

class CeresFunction final : public ceres::FirstOrderFunction {
 public:
  explicit CeresFunction(const Objective& objective) : objective_(objective) {}

  bool Evaluate(const double* at, double* value, double* gradient) const override {
    std::vector<bool> turned;
    const Point point = reflected(objective_, {at, objective_.parameters()}, turned);
    if (!objective_.evaluate(point, *value, gradient) || !std::isfinite(*value)) return false;
    for (std::size_t i = 0; gradient != nullptr && i < turned.size(); ++i)
      if (turned[i]) gradient[i] = -gradient[i];
    return true;
  }
  int NumParameters() const override { return static_cast<int>(objective_.parameters()); }

 private:
  const Objective& objective_;
};

/// Where Ceres's search ends: near the minimum, or at an end of the box.
VectorXd searched(const Objective& objective, const Point& start) {
  VectorXd at = Eigen::Map<const VectorXd>(start.data(), static_cast<Index>(start.size()));
  const ceres::GradientProblem problem(new CeresFunction(objective));
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.line_search_direction_type = ceres::BFGS;
  options.max_num_iterations = 200;
  options.max_line_search_step_expansion = 2;  // scales are logarithmic: ten steps on are far away
  options.function_tolerance = 1e-13;
  options.gradient_tolerance = 1e-12;
  options.parameter_tolerance = 1e-12;
  ceres::GradientProblemSolver::Summary summary;
  quiet_ceres();
  ceres::Solve(options, problem, at.data(), &summary);
  std::vector<bool> turned;
  const Point inside = reflected(objective, span_of(at), turned);
  return Eigen::Map<const VectorXd>(inside.data(), static_cast<Index>(inside.size()));
}

/// The gradient and the second derivatives there.
class Local {
 public:
  Local(const Objective& objective, const VectorXd& at)
      : gradient(VectorXd::Zero(at.size())), curvature(MatrixXd::Zero(at.size(), at.size())) {
    exists = objective.contains(span_of(at)) && objective.evaluate(span_of(at), value, gradient.data());
    for (Index i = 0; exists && i < at.size(); ++i) differentiate(objective, at, i);
    curvature = ((curvature + curvature.transpose()) / 2).eval();
  }

  double value = 0;
  bool exists = false;
  VectorXd gradient;
  MatrixXd curvature;

 private:
  /// Central differences; one-sided at an end of the box.
  void differentiate(const Objective& objective, const VectorXd& at, Index i) {
    const double h = 1e-4 * std::max(1.0, std::abs(at[i]));
    const auto end = static_cast<std::size_t>(i);
    VectorXd up = at, down = at, above(at.size()), below(at.size());
    up[i] = std::min(at[i] + h, objective.high[end]);
    down[i] = std::max(at[i] - h, objective.low[end]);
    double unused = 0;
    exists = objective.evaluate(span_of(up), unused, above.data()) &&
             objective.evaluate(span_of(down), unused, below.data());
    curvature.col(i) = (above - below) / (up[i] - down[i]);
  }
};

/// Parameters that lie at an end of the box while the function falls towards it.
std::vector<bool> ends(const Objective& objective, const VectorXd& at, const VectorXd& gradient) {
  std::vector<bool> found;
  for (Index i = 0; i < at.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    found.push_back((at[i] - objective.low[k] < near_an_end && gradient[i] > 0) ||
                    (objective.high[k] - at[i] < near_an_end && gradient[i] < 0));
  }
  return found;
}

/// Newton's step of the parameters that are free; those at an end stay.
VectorXd newton_step(const Local& local, const std::vector<bool>& stays) {
  MatrixXd curvature = local.curvature;
  VectorXd slope = local.gradient;
  for (Index i = 0; i < slope.size(); ++i) {
    if (!stays[static_cast<std::size_t>(i)]) continue;
    curvature.row(i).setZero();
    curvature.col(i).setZero();
    curvature(i, i) = 1;
    slope[i] = 0;
  }
  const Eigen::LDLT<MatrixXd> factors(curvature);
  if (factors.info() != Eigen::Success || !factors.isPositive() || factors.vectorD().minCoeff() <= 0)
    return VectorXd::Constant(slope.size(), std::nan(""));
  return factors.solve(-slope);
}

/// Moves a point onto an end of the box that is near, or towards which the function falls, where it is lower
/// there.
void settle(const Objective& objective, VectorXd& at) {
  VectorXd gradient = VectorXd::Zero(at.size());
  double value = 0;
  if (!objective.evaluate(span_of(at), value, gradient.data())) return;
  for (Index i = 0; i < at.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    for (const double end : {objective.low[k], objective.high[k]}) {
      const bool falls = (end - at[i]) * gradient[i] < 0;
      if (!std::isfinite(end) || (std::abs(at[i] - end) > 1e-2 && !falls)) continue;
      VectorXd moved = at;
      moved[i] = end;
      const double there = objective.value(span_of(moved));
      if (there > value) continue;
      at = moved;
      value = there;
    }
  }
}

/// Newton's steps while they shrink.
Minimum newton(const Objective& objective, VectorXd at) {
  Local local(objective, at);
  std::vector<bool> stays = ends(objective, at, local.gradient);
  double size = std::numeric_limits<double>::infinity();
  for (int i = 0; i < newton_steps && local.exists; ++i) {
    const VectorXd step = newton_step(local, stays);
    const double next = step.lpNorm<Eigen::Infinity>();
    if (!(next < size)) break;  // steps no longer shrink, or there is no curvature to follow
    size = next;
    const VectorXd moved = at + step;
    Local there(objective, moved);
    if (!there.exists || there.value > local.value + 1e-9 * std::max(1.0, std::abs(local.value))) break;
    at = moved;
    local = std::move(there);
    stays = ends(objective, at, local.gradient);
    if (size < small_step) break;
  }
  const bool at_end = std::ranges::any_of(stays, [](bool stay) { return stay; });
  const auto span = span_of(at);
  return {Point(span.begin(), span.end()), local.value,
          std::vector<double>(local.curvature.data(), local.curvature.data() + local.curvature.size()),
          local.exists && size < 1e-6, at_end};
}

}  // namespace

std::vector<double> Minimum::covariance() const {
  const auto size = static_cast<Index>(at.size());
  const MatrixXd second = Eigen::Map<const MatrixXd>(curvature.data(), size, size);
  const Eigen::LDLT<MatrixXd> factors(second);
  if (size == 0 || !second.allFinite() || factors.info() != Eigen::Success ||
      factors.vectorD().minCoeff() <= 0)
    return {};
  const MatrixXd inverse = factors.solve(MatrixXd::Identity(size, size));
  return {inverse.data(), inverse.data() + inverse.size()};
}

Minimum minimise(const Objective& objective, const Point& start) {
  RAMIFY_EXPECTS(objective.contains(start));
  VectorXd at = searched(objective, start);
  if (Minimum found = newton(objective, at); found.converged && !found.at_end) return found;
  settle(objective, at);
  return newton(objective, std::move(at));
}

Minimum minimise_near(const Objective& objective, const Point& start) {
  RAMIFY_EXPECTS(objective.contains(start));
  Minimum found =
      newton(objective, Eigen::Map<const VectorXd>(start.data(), static_cast<Index>(start.size())));
  return found.converged ? found : minimise(objective, start);
}

bool are_same(const Minimum& a, const Minimum& b) {
  return std::ranges::equal(a.at, b.at, [](double x, double y) { return std::abs(x - y) < 1e-4; });
}

std::vector<Minimum> minima(const Objective& objective, std::span<const Point> starts) {
  std::vector<Minimum> found;
  for (const Point& start : starts) {
    if (!std::isfinite(objective.value(start))) continue;
    Minimum minimum = minimise(objective, start);
    if (std::ranges::none_of(found, [&](const Minimum& other) { return are_same(other, minimum); }))
      found.push_back(std::move(minimum));
  }
  std::ranges::stable_sort(found, {}, &Minimum::value);
  return found;
}

}  // namespace ramify
