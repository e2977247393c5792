#include "ramify/draw/tree_layout.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

/// Read backwards the word is a postorder, siblings last to first: the stack holds the leftmost child on top.
std::vector<double> places_across(const Tree& tree, double tips) {
  std::vector<double> across(tree.node_count());
  std::vector<double> open;
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    const std::size_t children = tree.arity(node);
    if (children == 0) {
      across[node] = --tips;
    } else {
      across[node] = (open.back() + open[open.size() - children]) / 2;
      open.resize(open.size() - children);
    }
    open.push_back(across[node]);
  }
  return across;
}

}  // namespace

TreeLayout lay_out(const Tree& tree, std::span<const double> lengths) {
  RAMIFY_EXPECTS(tree.node_count() > 0);
  const auto tips = static_cast<double>(std::ranges::count(tree.arities(), 0u));
  TreeLayout layout{std::vector<double>(tree.node_count()), places_across(tree, tips)};
  layout.along[0] = lengths.empty() ? 0 : lengths[0];
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    layout.along[child] = layout.along[parent] + (lengths.empty() ? 1 : lengths[child]);
  });
  layout.length = *std::ranges::max_element(layout.along);
  layout.width = tips - 1;
  return layout;
}

}  // namespace ramify
