#pragma once

#include <span>

namespace ramify {

/// A node of a quadrature rule on a panel.
struct RuleNode {
  double at;
  double weight;
};

inline constexpr int rule_points = 10;

/// Gauss's rule for the counting measure on the whole numbers 0..count-1 (nodes: zeros of the discrete
/// Chebyshev polynomial): sums polynomials of degree 19 exactly. count > 10. The answer is kept for each
/// count; O(1) then.
std::span<const RuleNode> counting_rule(double count);

/// Gauss and Legendre's on (0,1).
std::span<const RuleNode> unit_rule();

}  // namespace ramify
