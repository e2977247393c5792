#include "ramify/statistic/node_labels.hpp"

#include <algorithm>

#include "ramify/statistic/height.hpp"
#include "ramify/statistic/strahler.hpp"
#include "ramify/tree/each_edge.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {
namespace {

/// The number of nodes below and including one: of the external ones alone, or of all.
template <bool all>
struct NodeCount {
  using Value = Size;
  Value external() const { return 1; }
  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& below) const {
    Size sum = all ? 1 : 0;
    for (const Size nodes : below) sum += nodes;
    return sum;
  }
};

template <class F>
std::vector<typename F::Value> values_of_nodes(const Tree& tree) {
  std::vector<typename F::Value> values(tree.node_count());
  F fold;
  measure(tree, fold, [&](std::size_t node, const auto& value) { values[node] = value; });
  return values;
}

/// Whether each node goes on with the main branch of its parent: the first of those with the largest rank.
template <class Rank>
std::vector<bool> main_children(const Tree& tree, const std::vector<Rank>& rank) {
  std::vector<std::size_t> chosen(tree.node_count(), 0);  // of each parent; the root is nobody's child
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    std::size_t& best = chosen[parent];
    if (best == 0 || rank[child] > rank[best]) best = child;
  });
  std::vector<bool> main(tree.node_count(), false);
  for (const std::size_t child : chosen) main[child] = true;
  return main;
}

std::vector<bool> main_children(const Tree& tree, MainChild rule) {
  switch (rule) {
    case MainChild::first:
      break;
    case MainChild::largest:
      return main_children(tree, magnitudes(tree));
    case MainChild::highest_order:
      return main_children(tree, strahler_orders(tree));
  }
  return main_children(tree, std::vector<std::uint8_t>(tree.node_count(), 0));
}

}  // namespace

std::vector<std::uint8_t> strahler_orders(const Tree& tree) {
  return values_of_nodes<Strahler>(tree);
}

std::vector<Size> magnitudes(const Tree& tree) {
  return values_of_nodes<NodeCount<false>>(tree);
}

std::vector<Size> node_counts(const Tree& tree) {
  return values_of_nodes<NodeCount<true>>(tree);
}

std::vector<std::uint32_t> horsfield_orders(const Tree& tree) {
  return values_of_nodes<Height>(tree);
}

std::vector<std::uint32_t> depths(const Tree& tree) {
  std::vector<std::uint32_t> depths(tree.node_count(), 1);
  each_edge(tree, [&](std::size_t parent, std::size_t child) { depths[child] = depths[parent] + 1; });
  return depths;
}

std::vector<std::uint32_t> horsfield_orders_from_root(const Tree& tree) {
  std::vector<std::uint32_t> orders = depths(tree);
  const std::uint32_t height = *std::ranges::max_element(orders);
  for (std::uint32_t& order : orders) order = height - order + 1;
  return orders;
}

std::vector<PathNodes> path_nodes(const Tree& tree, MainChild rule) {
  const std::vector<bool> main = main_children(tree, rule);
  std::vector<PathNodes> counts(tree.node_count(), {1, 0});
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    const PathNodes& above = counts[parent];
    counts[child] =
        main[child] ? PathNodes{above.main + 1, above.secondary} : PathNodes{above.main, above.secondary + 1};
  });
  return counts;
}

}  // namespace ramify
