#pragma once

#include <vector>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// Calls visit(parent, child) for every edge, parents first, the children of a node in their order. O(nodes)
/// time, O(height) memory.
template <class Visit>
void each_edge(const Tree& tree, Visit visit) {
  struct Open {
    std::size_t node;
    std::uint32_t missing;
  };
  std::vector<Open> path;
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    if (!path.empty()) {
      visit(path.back().node, node);
      --path.back().missing;
    }
    path.push_back({node, tree.arity(node)});
    while (!path.empty() && path.back().missing == 0) path.pop_back();
  }
}

/// The parent of every node by its number in preorder, from 1; 0 of the root. O(nodes).
inline std::vector<std::size_t> parent_numbers(const Tree& tree) {
  std::vector<std::size_t> parents(tree.node_count(), 0);
  each_edge(tree, [&](std::size_t parent, std::size_t child) { parents[child] = parent + 1; });
  return parents;
}

/// The node after the last one below and including `node`, in preorder. O(size of the subtree).
inline std::size_t subtree_end(const Tree& tree, std::size_t node) {
  std::size_t owed = 1;
  for (; owed > 0; ++node) owed += tree.arity(node) - std::size_t{1};
  return node;
}

}  // namespace ramify
