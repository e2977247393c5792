#include "ramify/format/rerooted.hpp"

#include <algorithm>

#include "ramify/tree/each_edge.hpp"

namespace ramify::detail {

RowTree rerooted(const RowTree& tree, std::size_t node) {
  const std::size_t nodes = tree.rows.size();
  std::vector<std::size_t> parents(nodes, nodes);
  each_edge(tree.tree, [&](std::size_t parent, std::size_t child) { parents[child] = parent; });
  for (std::size_t above = nodes, on = node; on != nodes;) {
    const std::size_t next = parents[on];
    parents[on] = above;
    above = on;
    on = next;
  }
  std::vector<std::vector<std::size_t>> children(nodes);
  for (std::size_t child = 0; child < nodes; ++child)
    if (child != node) children[parents[child]].push_back(child);
  std::vector<std::uint32_t> arity, rows;
  for (std::vector<std::size_t> pending{node}; !pending.empty();) {
    const std::size_t on = pending.back();
    pending.pop_back();
    rows.push_back(tree.rows[on]);
    auto& below = children[on];
    arity.push_back(static_cast<std::uint32_t>(below.size()));
    std::ranges::sort(below, std::ranges::greater(), [&](std::size_t child) { return tree.rows[child]; });
    pending.insert(pending.end(), below.begin(), below.end());
  }
  return {Tree(std::move(arity)), std::move(rows)};
}

}  // namespace ramify::detail
