#pragma once

#include <span>
#include <vector>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// Where the nodes of a tree lie, by preorder place, in units of the tree: no page, no direction.
struct TreeLayout {
  std::vector<double> along;  ///< the way from the foot of the tree
  std::vector<double>
      across;         ///< tips at 0, 1, 2, ... in their order; a fork midway between its outer children
  double length = 0;  ///< the largest along
  double width = 0;   ///< the largest across
};

/// @param tree     at least one node
/// @param lengths  of the branch below every node, by preorder place, finite and at least 0: along is their
/// sum from the
///                 root's own on. Empty: along counts edges from the root.
/// O(nodes) time, 16 bytes a node.
TreeLayout lay_out(const Tree& tree, std::span<const double> lengths);

}  // namespace ramify
