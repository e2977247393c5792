#include "ramify/measure/tree_measurement.hpp"

#include <limits>
#include <utility>

#include "ramify/sample/measure_tree.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/stream_geometry.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {
namespace {

std::vector<std::uint64_t> up_to(const HortonStrahler::Counts& counts, std::size_t highest) {
  return {counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(highest) + 1};
}

void add_geometry(const RecordedTree& tree, MeasuredOrders& orders) {
  if (tree.lengths.empty() && tree.radii.empty()) return;
  StreamGeometry geometry = stream_geometry(tree.tree, tree.lengths, tree.radii);
  orders.mean_lengths = std::move(geometry.mean_lengths);
  orders.mean_radii = std::move(geometry.mean_radii);
  orders.murray = murray_exponent(tree.tree, tree.radii);
}

}  // namespace

MeasuredOrders measure_orders(const RecordedTree& tree) {
  HortonStrahler fold;
  const std::size_t highest = measure(tree.tree, fold);
  MeasuredOrders orders{tree.name, up_to(fold.nodes(), highest), up_to(fold.streams(), highest), {}, {}, {}};
  add_geometry(tree, orders);
  return orders;
}

TreeMeasurement measure_all(const RecordedTree& tree) {
  constexpr StreamKey key{1996, 0};
  TreeMeasurement all;
  all.measures = measure_tree(tree.tree, key, 0);
  const std::size_t highest = all.measures->strahler;
  all.orders = {tree.name, up_to(all.measures->nodes, highest), up_to(all.measures->streams, highest), {}, {},
                {}};
  add_geometry(tree, all.orders);
  return all;
}

MeasuredOrders measure_orders(const OrderCounts& counts) {
  MeasuredOrders orders{counts.name, {}, counts.counts, counts.lengths, counts.diameters, counts.areas};
  for (double& radius : orders.mean_radii) radius /= 2;
  return orders;
}

double pooled_over_orders(const std::vector<std::uint64_t>& counts) {
  if (counts.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const std::uint64_t count : counts) sum += static_cast<double>(count);
  return (sum - static_cast<double>(counts.back())) / (sum - static_cast<double>(counts.front()));
}

}  // namespace ramify
