#pragma once

#include <cstdint>
#include <vector>

#include "ramify/tree/tree.hpp"

/// A number for every node of a stored tree, by its place in preorder. Trees of any arity; O(nodes) each.
namespace ramify {

/// Horton-Strahler order (B6, B22), leaf order 0.
std::vector<std::uint8_t> strahler_orders(const Tree& tree);

/// Shreve magnitude (B2): external nodes below and including the node.
std::vector<Size> magnitudes(const Tree& tree);

/// Nodes below and including the node, external ones among them.
std::vector<Size> node_counts(const Tree& tree);

/// Weibel's generation (B3): nodes on the path from the root, both ends counted. Weibel 1963 counts from 0:
/// one less.
std::vector<std::uint32_t> depths(const Tree& tree);

/// Horsfield order (B5) as Horsfield and Cumming 1968 have it: 1 for an external node, else one more than the
/// highest child.
std::vector<std::uint32_t> horsfield_orders(const Tree& tree);

/// Horsfield order as K96 2.1.1 has it: height - depth + 1. The same on the longest paths from the root alone
/// (X35).
std::vector<std::uint32_t> horsfield_orders_from_root(const Tree& tree);

/// Which child of a node goes on with the main branch (B20). Of equals the first.
enum class MainChild { first, largest, highest_order };

/// Main and secondary nodes on the path from the root, both ends counted (B20): the root is main, so main +
/// secondary is the depth. Kruszewski 1996, 4.2.2.
struct PathNodes {
  std::uint32_t main, secondary;
  friend bool operator==(const PathNodes&, const PathNodes&) = default;
};
std::vector<PathNodes> path_nodes(const Tree& tree, MainChild rule);

}  // namespace ramify
