#include <cmath>

#include <fmt/format.h>

#include "ramify/format/swc.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

/// x of every node: the middle of the leaves below it.
std::vector<double> middles(const Tree& tree, const std::vector<Size>& leaves) {
  std::vector<double> x(tree.node_count());
  double left = 0;  // leaves before the node, in preorder
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    x[node] = left + static_cast<double>(leaves[node] - 1) / 2;
    if (tree.arity(node) == 0) ++left;
  }
  return x;
}

std::vector<Size> leaves_below(const Tree& tree, const std::vector<std::size_t>& parents) {
  std::vector<Size> leaves(tree.node_count(), 0);
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    if (tree.arity(node) == 0) leaves[node] = 1;
    if (node > 0) leaves[parents[node]] += leaves[node];
  }
  return leaves;
}

void append_points(std::string& text, const Tree& tree, std::size_t first_id) {
  std::vector<std::size_t> parents(tree.node_count(), 0), depths(tree.node_count(), 0);
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    parents[child] = parent;
    depths[child] = depths[parent] + 1;
  });
  const auto leaves = leaves_below(tree, parents);
  const auto x = middles(tree, leaves);
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    const std::string parent = node == 0 ? "-1" : std::to_string(first_id + parents[node]);
    text += fmt::format("{} {} {} {} 0 {:.4g} {}\n", first_id + node, node == 0 ? 1 : 3, x[node],
                        depths[node], 0.1 * std::cbrt(static_cast<double>(leaves[node])), parent);
  }
}

}  // namespace

std::string write_swc(const std::vector<RecordedTree>& trees) {
  std::string text = "# id type x y z radius parent\n";
  std::size_t first_id = 1;
  for (const RecordedTree& tree : trees) {
    append_points(text, tree.tree, first_id);
    first_id += tree.tree.node_count();
  }
  return text;
}

}  // namespace ramify
