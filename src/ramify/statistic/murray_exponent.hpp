#pragma once

#include <cstdint>
#include <span>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// Murray's exponent of a tree with radii: x in r0^x = r1^x + ... + rk^x where a branch of radius r0 forks
/// into k >= 2 (Murray 1926 has 3; da Vinci 2; C25).
struct MurrayExponent {
  /// Median over the forks of the x that solves the equation of the fork. It has one and only one where all
  /// children are thinner than their parent; a fork with a child as thick or thicker counts as infinite. NaN
  /// where the median is infinite, or there is no fork.
  double median;
  std::uint64_t forks;     ///< with the radii of all their branches known and above 0
  std::uint64_t infinite;  ///< among them: a child as thick as its parent, or thicker
};

/// @param radii  of every node in preorder, NaN where one has none; or empty
/// O(nodes) time and memory.
MurrayExponent murray_exponent(const Tree& tree, std::span<const double> radii);

}  // namespace ramify
