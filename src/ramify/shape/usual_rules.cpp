#include "ramify/shape/usual_rules.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

constexpr double golden_divergence = 137.5;

ExtentRule extent_of(std::string_view name, const std::vector<double>& constants) {
  return named_rule(extent_rules(), name, constants);
}

DeviationRule deviation_of(std::string_view name, const std::vector<double>& constants) {
  return named_rule(deviation_rules(), name, constants);
}

/// Values that a form can have, of every node.
void require_extents(const RecordedTree& tree, const std::vector<double>& values, std::string_view what) {
  for (std::size_t node = 0; node < values.size(); ++node) {
    if (std::isfinite(values[node]) && values[node] >= 0) continue;
    const std::string name(tree.names[node]);
    throw Error(fmt::format("{}: node {}{} has the {} {}", tree.name, node + 1,
                            name.empty() ? "" : " (" + name + ")", what, values[node]),
                "a form is to scale", "mend the file, or draw it with --style dendrogram --same-lengths");
  }
}

std::vector<double> own_lengths(const RecordedTree& tree) {
  if (tree.lengths.empty()) return std::vector<double>(tree.tree.node_count(), 1);
  std::vector<double> lengths = tree.lengths;
  if (std::isnan(lengths[0])) lengths[0] = 0;
  require_extents(tree, lengths, "length");
  return lengths;
}

double longest_path(const Tree& tree, const std::vector<double>& lengths) {
  std::vector<double> ways = lengths;
  each_edge(tree, [&](std::size_t parent, std::size_t child) { ways[child] += ways[parent]; });
  return *std::ranges::max_element(ways);
}

ExtentRule listed(std::vector<double> values) {
  return [values = std::move(values)](const ExtentQuestion& q) { return values[q.node.node]; };
}

ExtentRule leonardos_radii(const Tree& tree, const std::vector<double>& lengths) {
  constexpr double slenderness = 40;
  const auto leaves = static_cast<double>(std::ranges::count(tree.arities(), 0u));
  const double c = longest_path(tree, lengths) / slenderness / std::sqrt(leaves);
  return extent_of("leaves_power", {c, 2});
}

}  // namespace

ShapeRules thesis_rules(const Tree& tree) {
  const bool is_binary =
      std::ranges::all_of(tree.arities(), [](auto arity) { return arity == 0 || arity == 2; });
  ShapeRules rules{extent_of("leaves_power", {1, 3}), extent_of("radius_power", {10, 1}),
                   is_binary ? deviation_of("murray", {}) : deviation_of("radius_share", {90})};
  if (!is_binary) rules.arrangement = Arrangement::whorl;
  rules.plane.angle = golden_divergence;
  return rules;
}

ShapeRules measured_rules(const RecordedTree& tree) {
  const std::vector<double> lengths = own_lengths(tree);
  require_extents(tree, tree.radii, "radius");
  ShapeRules rules{tree.radii.empty() ? leonardos_radii(tree.tree, lengths) : listed(tree.radii),
                   listed(lengths), deviation_of("nodes_share", {70})};
  rules.plane.angle = golden_divergence;
  return rules;
}

Shape measured_shape(const RecordedTree& tree, Upwards upwards) {
  require_extents(tree, tree.radii, "radius");
  const auto place = [&](std::size_t node) -> Point3 {
    const auto& [x, y, z] = tree.places[node];
    return upwards == Upwards::y ? Point3{x, y, z} : Point3{x, z, -y};
  };
  Shape shape{std::vector<Limb>(tree.tree.node_count())};
  shape.limbs[0] = {place(0), place(0), tree.radii[0]};
  each_edge(tree.tree, [&](std::size_t parent, std::size_t child) {
    shape.limbs[child] = {place(parent), place(child), tree.radii[child]};
  });
  return shape;
}

}  // namespace ramify
