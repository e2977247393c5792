#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// What is written at the nodes of a diagram (G13).
enum class NodeNumber : std::uint8_t {
  order,    ///< Horton-Strahler
  depth,    ///< nodes on the path from the root, both ends counted
  leaves,   ///< external nodes below and including it
  balance,  ///< edges to a child with no more leaves than any sibling, the most on a path down (B16)
  /// B* as the thesis prints it (B17): 0 of an empty subtree, so 1 of an external node and balance + 1 of
  /// every other (X33). From 0 at the external nodes it would be balance once more, node by node.
  alternate_balance,
};

/// By its name here; throws Error for another, with the nearest.
NodeNumber parse_node_number(const std::string& name);

/// By preorder place. @param leaf_order  of external nodes, of the orders alone: 0 or 1. O(nodes).
std::vector<std::uint64_t> node_numbers(const Tree& tree, NodeNumber kind, unsigned leaf_order);

}  // namespace ramify
