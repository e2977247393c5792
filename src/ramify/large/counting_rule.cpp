#include "ramify/large/counting_rule.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <vector>

#include <Eigen/Eigenvalues>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// Golub and Welsch: nodes and weights from the recurrence of the orthogonal polynomials, p_(k+1) = (x -
/// middle) p_k - beta_k p_(k-1).
template <class Beta>
std::vector<RuleNode> gauss_rule(double middle, double mass, Beta beta) {
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(rule_points, 0), off(rule_points - 1);
  for (int k = 1; k < rule_points; ++k) off[k - 1] = std::sqrt(beta(k));
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, off);
  std::vector<RuleNode> nodes;
  for (int q = 0; q < rule_points; ++q) {
    const double first = solver.eigenvectors()(0, q);
    nodes.push_back({middle + solver.eigenvalues()[q], mass * first * first});
  }
  return nodes;
}

}  // namespace

std::span<const RuleNode> counting_rule(double count) {
  RAMIFY_EXPECTS(count > rule_points);
  static std::map<double, std::vector<RuleNode>> rules;
  static std::mutex guard;
  const std::scoped_lock lock(guard);
  auto& rule = rules[count];
  if (rule.empty())
    rule = gauss_rule((count - 1) / 2, count, [count](int order) {
      const double k2 = static_cast<double>(order) * order;
      return k2 / (4 * k2 - 1) * (count - order) * (count + order) / 4;
    });
  return rule;
}

std::span<const RuleNode> unit_rule() {
  static const auto rule = gauss_rule(0.5, 1, [](int order) {
    const double k2 = static_cast<double>(order) * order;
    return k2 / (4 * k2 - 1) / 4;
  });
  return rule;
}

}  // namespace ramify
