#include "ramify/shape/shape_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/node_labels.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

double length_of(const Limb& limb) {
  return std::hypot(limb.end[0] - limb.start[0], limb.end[1] - limb.start[1], limb.end[2] - limb.start[2]);
}

/// Whether a node begins a stream: its mother, if any, is of another order.
std::vector<bool> stream_heads(const Tree& tree, const std::vector<std::uint8_t>& orders) {
  std::vector<bool> heads(tree.node_count(), true);
  each_edge(tree,
            [&](std::size_t parent, std::size_t child) { heads[child] = orders[child] != orders[parent]; });
  return heads;
}

std::vector<OrderExtents> order_extents(const Tree& tree, const Shape& shape) {
  const auto orders = strahler_orders(tree);
  const auto heads = stream_heads(tree, orders);
  std::vector<OrderExtents> sums;
  for (unsigned order = 1; order <= orders[0]; ++order) sums.push_back({order + 1, 0, 0, 0, 0, 0});
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    if (tree.arity(node) == 0 || orders[node] == 0) continue;
    OrderExtents& sum = sums[orders[node] - 1u];
    sum.cylinders += 1;
    sum.streams += heads[node] ? 1 : 0;
    sum.mean_radius += shape.limbs[node].radius;
    sum.mean_length += length_of(shape.limbs[node]);
  }
  for (OrderExtents& sum : sums) {
    sum.mean_stream_length = sum.mean_length / sum.streams;
    sum.mean_radius /= sum.cylinders;
    sum.mean_length /= sum.cylinders;
  }
  return sums;
}

}  // namespace

ShapeMeasures measure_shape(const Tree& tree, const Shape& shape) {
  RAMIFY_EXPECTS(tree.node_count() == shape.limbs.size() && tree.node_count() > 0);
  const Point3 foot = shape.limbs[0].start;
  ShapeMeasures measures{0, 0, 0, 0, 0, order_extents(tree, shape)};
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    if (tree.arity(node) == 0) continue;
    const Limb& limb = shape.limbs[node];
    const double length = length_of(limb);
    measures.volume += std::numbers::pi * limb.radius * limb.radius * length;
    measures.surface += 2 * std::numbers::pi * limb.radius * length;
    measures.length += length;
    measures.height = std::max(measures.height, limb.end[1] - foot[1]);
    measures.spread = std::max(measures.spread, std::hypot(limb.end[0] - foot[0], limb.end[2] - foot[2]));
  }
  return measures;
}

}  // namespace ramify
