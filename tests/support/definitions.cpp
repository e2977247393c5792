#include "support/definitions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace ramify::test {
namespace {

/// The depths (root = 1) of all external nodes.
void walk_to_leaves(const Shape& shape, std::size_t depth, std::vector<std::size_t>& depths) {
  if (shape.is_external()) depths.push_back(depth);
  for (const Shape& child : shape.children) walk_to_leaves(child, depth + 1, depths);
}

void visit(const Shape& shape, const std::function<void(const Shape&)>& look) {
  look(shape);
  for (const Shape& child : shape.children) visit(child, look);
}

/// Cuts off every external node, then contracts the nodes left with one child.
Shape prune(const Shape& shape) {
  Shape pruned;
  for (const Shape& child : shape.children)
    if (!child.is_external()) pruned.children.push_back(prune(child));
  if (pruned.children.size() == 1) return pruned.children.front();
  return pruned;
}

void count_levels(const Shape& shape, std::size_t level, std::vector<std::uint64_t>& counts) {
  ++counts[level];
  for (const Shape& child : shape.children) count_levels(child, level + 1, counts);
}

void walk_edges(const Shape& shape, std::size_t so_far, std::size_t& most) {
  most = std::max(most, so_far);
  for (const Shape& child : shape.children) {
    const bool smallest =
        std::all_of(shape.children.begin(), shape.children.end(),
                    [&](const Shape& sibling) { return external_nodes(child) <= external_nodes(sibling); });
    walk_edges(child, so_far + (smallest && shape.children.size() > 1 ? 1 : 0), most);
  }
}

void walk_to_last(const Shape& shape, std::size_t depth, double probability,
                  std::map<std::size_t, double>& law) {
  const double others = static_cast<double>(internal_nodes(shape) - 1);
  if (others == 0) law[depth] += probability;
  for (const Shape& child : shape.children)
    if (!child.is_external())
      walk_to_last(child, depth + 1, probability * static_cast<double>(internal_nodes(child)) / others, law);
}

void walk_to_nodes(const Shape& shape, std::uint64_t edges,
                   const std::function<void(const Shape&, std::uint64_t)>& look) {
  look(shape, edges);
  for (const Shape& child : shape.children) walk_to_nodes(child, edges + 1, look);
}

/// Of the children, the highest first.
std::vector<std::size_t> orders_below(const Shape& node) {
  std::vector<std::size_t> orders;
  for (const Shape& child : node.children) orders.push_back(strahler(child));
  std::sort(orders.rbegin(), orders.rend());
  return orders;
}

/// Of every external node, which children lead to it.
using Path = std::vector<std::size_t>;

void walk_paths(const Shape& shape, Path path, std::vector<Path>& paths) {
  if (shape.is_external()) paths.push_back(path);
  path.push_back(0);
  for (const Shape& child : shape.children) {
    walk_paths(child, path, paths);
    ++path.back();
  }
}

std::vector<Path> paths_to_leaves(const Shape& shape) {
  std::vector<Path> paths;
  walk_paths(shape, {}, paths);
  return paths;
}

/// Edges from the root to the last common node.
std::size_t common(const Path& a, const Path& b) {
  const auto parting = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(parting.first - a.begin());
}

bool part_two_and_two(const Path& a, const Path& b, const Path& c, const Path& d) {
  const std::size_t all = std::min({common(a, b), common(a, c), common(a, d)});
  return common(a, b) > all && common(c, d) > all;
}

/// Look at the external nodes below either child of every node that has two.
void visit_forks(const Shape& shape, const std::function<void(double, double)>& look) {
  visit(shape, [&](const Shape& node) {
    if (node.children.size() == 2)
      look(static_cast<double>(external_nodes(node.children[0])),
           static_cast<double>(external_nodes(node.children[1])));
  });
}

/// The same for shapes that differ by the order of children and by one-child nodes alone.
std::string unordered_word(const Shape& shape) {
  if (shape.children.size() == 1) return unordered_word(shape.children[0]);
  std::vector<std::string> words;
  for (const Shape& child : shape.children) words.push_back(unordered_word(child));
  std::sort(words.begin(), words.end());
  return "(" + std::accumulate(words.begin(), words.end(), std::string()) + ")";
}

double walk_entropy(const Shape& shape, double probability) {
  if (shape.is_external()) return -probability * std::log2(probability);
  double sum = 0;
  for (const Shape& child : shape.children)
    sum += walk_entropy(child, probability / static_cast<double>(shape.children.size()));
  return sum;
}

}  // namespace

std::uint64_t internal_nodes(const Shape& shape) {
  std::uint64_t count = 0;
  visit(shape, [&](const Shape& node) { count += node.is_external() ? 0 : 1; });
  return count;
}

std::uint64_t external_nodes(const Shape& shape) {
  std::uint64_t count = 0;
  visit(shape, [&](const Shape& node) { count += node.is_external() ? 1 : 0; });
  return count;
}

std::size_t strahler(const Shape& shape) {
  if (shape.is_external()) return 0;
  std::vector<std::size_t> below;
  for (const Shape& child : shape.children) below.push_back(strahler(child));
  std::sort(below.rbegin(), below.rend());
  return below.size() > 1 && below[0] == below[1] ? below[0] + 1 : below[0];
}

std::size_t strahler_by_pruning(const Shape& shape) {
  Shape rest = shape;
  std::size_t prunings = 0;
  for (; !rest.is_external(); ++prunings) rest = prune(rest);
  return prunings;
}

std::vector<std::uint64_t> nodes_per_order(const Shape& shape) {
  std::vector<std::uint64_t> counts(strahler(shape) + 1, 0);
  visit(shape, [&](const Shape& node) { ++counts[strahler(node)]; });
  return counts;
}

std::vector<std::uint64_t> streams_per_order(const Shape& shape) {
  // A class is a chain, so it has one edge less than it has nodes.
  std::vector<std::uint64_t> counts = nodes_per_order(shape);
  visit(shape, [&](const Shape& node) {
    for (const Shape& child : node.children)
      if (strahler(child) == strahler(node)) --counts[strahler(node)];
  });
  return counts;
}

std::size_t height(const Shape& shape) {
  std::vector<std::size_t> depths;
  walk_to_leaves(shape, 1, depths);
  return *std::max_element(depths.begin(), depths.end());
}

std::vector<std::uint64_t> nodes_per_level(const Shape& shape) {
  std::vector<std::uint64_t> counts(height(shape), 0);
  count_levels(shape, 0, counts);
  return counts;
}

std::size_t fill_level(const Shape& shape) {
  const auto counts = nodes_per_level(shape);
  std::size_t level = 0;
  while (level + 1 < counts.size() && counts[level + 1] == std::uint64_t{1} << (level + 1)) ++level;
  return level;
}

std::size_t level_of_first_gap(const Shape& shape) {
  std::size_t least = height(shape);
  walk_to_nodes(shape, 0, [&](const Shape& node, std::uint64_t level) {
    if (node.children.size() < 2) least = std::min<std::size_t>(least, level);
  });
  return least;
}

std::size_t balance(const Shape& shape) {
  std::size_t most = 0;
  walk_edges(shape, 0, most);
  return most;
}

std::map<std::size_t, double> last_node_depth_law(const Shape& shape) {
  if (shape.is_external()) return {{0, 1.0}};
  std::map<std::size_t, double> law;
  walk_to_last(shape, 1, 1.0, law);
  return law;
}

std::map<std::size_t, double> external_depth_law(const Shape& shape) {
  std::vector<std::size_t> depths;
  walk_to_leaves(shape, 1, depths);
  std::map<std::size_t, double> law;
  for (const std::size_t depth : depths) law[depth] += 1 / static_cast<double>(depths.size());
  return law;
}

std::uint64_t path_length(const Shape& shape) {
  std::uint64_t sum = 0;
  walk_to_nodes(shape, 0,
                [&](const Shape& node, std::uint64_t edges) { sum += node.is_external() ? 0 : edges; });
  return sum;
}

std::uint64_t sackin(const Shape& shape) {
  std::uint64_t sum = 0;
  walk_to_nodes(shape, 0,
                [&](const Shape& node, std::uint64_t edges) { sum += node.is_external() ? edges : 0; });
  return sum;
}

double colless(const Shape& shape) {
  double sum = 0;
  visit(shape, [&](const Shape& node) {
    if (node.children.size() > 2) sum = std::numeric_limits<double>::quiet_NaN();
    if (node.children.size() != 2) return;
    const auto left = external_nodes(node.children[0]), right = external_nodes(node.children[1]);
    sum += static_cast<double>(std::max(left, right) - std::min(left, right));
  });
  return sum;
}

double total_cophenetic(const Shape& shape) {
  const auto paths = paths_to_leaves(shape);
  double sum = 0;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) sum += static_cast<double>(common(paths[i], paths[j]));
  return sum;
}

double rooted_quartets(const Shape& shape) {
  const auto p = paths_to_leaves(shape);
  double balanced = 0;
  for (std::size_t a = 0; a < p.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::size_t c = 0; c < b; ++c)
        for (std::size_t d = 0; d < c; ++d)
          if (part_two_and_two(p[a], p[b], p[c], p[d]) || part_two_and_two(p[a], p[c], p[b], p[d]) ||
              part_two_and_two(p[a], p[d], p[b], p[c]))
            ++balanced;
  return 3 * balanced;
}

double b1(const Shape& shape) {
  double sum = 0;
  walk_to_nodes(shape, 0, [&](const Shape& node, std::uint64_t edges) {
    if (edges > 0 && !node.is_external()) sum += 1 / static_cast<double>(height(node) - 1);
  });
  return sum;
}

double b2(const Shape& shape) {
  return walk_entropy(shape, 1);
}

double average_leaf_depth(const Shape& shape) {
  return static_cast<double>(sackin(shape)) / static_cast<double>(external_nodes(shape));
}

double variance_leaf_depth(const Shape& shape) {
  const double mean = average_leaf_depth(shape);
  double sum = 0;
  for (const Path& path : paths_to_leaves(shape))
    sum += (static_cast<double>(path.size()) - mean) * (static_cast<double>(path.size()) - mean);
  return sum / static_cast<double>(external_nodes(shape));
}

double stairs1(const Shape& shape) {
  double forks = 0, uneven = 0;
  visit_forks(shape, [&](double left, double right) {
    ++forks;
    uneven += left != right ? 1 : 0;
  });
  return uneven / forks;
}

double stairs2(const Shape& shape) {
  double forks = 0, sum = 0;
  visit_forks(shape, [&](double left, double right) {
    ++forks;
    sum += std::min(left / right, right / left);
  });
  return sum / forks;
}

std::uint64_t symmetry_nodes(const Shape& shape) {
  std::uint64_t count = 0;
  visit(shape, [&](const Shape& node) {
    if (node.children.size() == 2 && unordered_word(node.children[0]) != unordered_word(node.children[1]))
      ++count;
  });
  return count;
}

std::uint64_t pitchforks(const Shape& shape) {
  std::uint64_t count = 0;
  visit(shape, [&](const Shape& node) {
    if (node.children.size() > 1 && external_nodes(node) == 3) ++count;
  });
  return count;
}

double j1(const Shape& shape) {
  double sum = 0, weights = 0;
  visit(shape, [&](const Shape& node) {
    if (node.is_external()) return;
    const auto leaves = static_cast<double>(external_nodes(node));
    double entropy = 0;
    for (const Shape& child : node.children) {
      const double share = static_cast<double>(external_nodes(child)) / leaves;
      if (share < 1) entropy -= share * std::log(share) / std::log(static_cast<double>(node.children.size()));
    }
    sum += leaves * entropy;
    weights += leaves;
  });
  return sum / weights;
}

std::uint64_t cherries(const Shape& shape) {
  std::uint64_t count = 0;
  const auto ends = [](const Shape& child) { return external_nodes(child) == 1; };
  visit(shape, [&](const Shape& node) {
    const auto& children = node.children;
    if (children.size() >= 2 && std::all_of(children.begin(), children.end(), ends)) ++count;
  });
  return count;
}

std::size_t registers(const Shape& shape) {
  if (shape.is_external()) return 1;
  const std::size_t left = registers(shape.children[0]), right = registers(shape.children[1]);
  const std::size_t left_first = std::max(left, right + 1), right_first = std::max(right, left + 1);
  return std::min(left_first, right_first);
}

std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> bi_orders(const Shape& shape) {
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> counts;
  visit(shape, [&](const Shape& node) {
    const auto orders = orders_below(node);
    if (orders.size() >= 2) ++counts[{orders[0], orders[1]}];
  });
  return counts;
}

std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> side_branches(const Shape& shape) {
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> counts;
  visit(shape, [&](const Shape& node) {
    const auto orders = orders_below(node);
    if (orders.empty()) return;
    // One child continues the node's stream, or two of equal order begin it; all others end here.
    const bool begins = orders.size() >= 2 && orders[0] == orders[1];
    for (std::size_t i = begins ? 2 : 1; i < orders.size(); ++i) ++counts[{strahler(node), orders[i]}];
  });
  return counts;
}

double mean_ratio(const std::vector<std::uint64_t>& counts) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < counts.size(); ++k)
    sum += static_cast<double>(counts[k]) / static_cast<double>(counts[k + 1]);
  return sum / static_cast<double>(counts.size() - 1);
}

}  // namespace ramify::test
