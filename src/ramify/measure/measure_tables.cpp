#include "ramify/measure/measure_tables.hpp"

#include <algorithm>

#include "ramify/measure/column_value.hpp"
#include "ramify/statistic/node_labels.hpp"
#include "ramify/statistic/statistic_set.hpp"
#include "ramify/statistic/stream_geometry.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

template <class Trees, class Has>
bool any(const Trees& trees, Has has) {
  return std::ranges::any_of(trees, has);
}

/// Length and radius of an order, or of a node: a field each where the table has the column.
void add_geometry(Row& row, bool has_column, const std::vector<double>& values, std::size_t place) {
  if (!has_column) return;
  if (values.empty()) {
    row.nothing();
  } else {
    row.summary(values[place]);
  }
}

void add_ratios(Row& row, const std::vector<double>& means) {
  const MeanRatios ratios = mean_ratios(means);
  row.summary(ratios.mean_ratio).summary(ratios.regression).summary(ratios.geometric);
}

std::vector<std::string> ratio_columns(const std::string& what) {
  return {what + "_mean_ratio", what + "_regression", what + "_geometric"};
}

}  // namespace

Table orders_table(const std::vector<MeasuredOrders>& trees, unsigned leaf_order) {
  const bool lengths = any(trees, [](const auto& tree) { return !tree.mean_lengths.empty(); });
  const bool radii = any(trees, [](const auto& tree) { return !tree.mean_radii.empty(); });
  const bool areas = any(trees, [](const auto& tree) { return !tree.mean_areas.empty(); });
  std::vector<std::string> header{"tree", "leaf_order", "order", "nodes", "streams"};
  if (lengths) header.emplace_back("mean_length");
  if (radii) header.emplace_back("mean_radius");
  if (areas) header.emplace_back("mean_area");
  Table table(std::move(header));
  for (const MeasuredOrders& tree : trees) {
    for (std::size_t k = 0; k < tree.streams.size(); ++k) {
      Row row;
      row.text(tree.name).whole(leaf_order).whole(k + leaf_order);
      if (tree.nodes.empty()) {
        row.nothing();
      } else {
        row.whole(tree.nodes[k]);
      }
      row.whole(tree.streams[k]);
      add_geometry(row, lengths, tree.mean_lengths, k);
      add_geometry(row, radii, tree.mean_radii, k);
      add_geometry(row, areas, tree.mean_areas, k);
      table.add(std::move(row));
    }
  }
  return table;
}

Table summary_table(const std::vector<TreeMeasurement>& trees, unsigned leaf_order,
                    const std::optional<StatisticSet>& chosen) {
  const bool whole = !chosen;  // statistics, and what is no statistic
  const bool lengths =
      whole && any(trees, [](const auto& tree) { return !tree.orders.mean_lengths.empty(); });
  const bool radii = whole && any(trees, [](const auto& tree) { return !tree.orders.mean_radii.empty(); });
  const bool areas = whole && any(trees, [](const auto& tree) { return !tree.orders.mean_areas.empty(); });
  std::size_t largest = 0;
  for (const auto& tree : trees) largest = std::max(largest, tree.orders.streams.size() - 1);
  const auto columns = chosen.value_or(StatisticSet::all()).columns(largest);
  std::vector<std::string> header{"tree", "leaf_order"};
  for (const auto& column : columns) header.push_back(column.name(leaf_order));
  if (whole) header.insert(header.end(), {"nodes_pooled_ratio", "streams_pooled_ratio"});
  if (lengths) std::ranges::copy(ratio_columns("length"), std::back_inserter(header));
  if (radii) {
    std::ranges::copy(ratio_columns("radius"), std::back_inserter(header));
    header.insert(header.end(), {"murray_exponent", "murray_forks", "murray_infinite"});
  }
  if (areas) std::ranges::copy(ratio_columns("area"), std::back_inserter(header));
  Table table(std::move(header));
  for (const TreeMeasurement& tree : trees) {
    Row row;
    row.text(tree.orders.name).whole(leaf_order);
    for (const auto& column : columns) row.summary(detail::value_of(column, tree, leaf_order));
    if (whole)
      row.summary(pooled_over_orders(tree.orders.nodes)).summary(pooled_over_orders(tree.orders.streams));
    if (lengths) add_ratios(row, tree.orders.mean_lengths);
    if (radii) {
      add_ratios(row, tree.orders.mean_radii);
      row.summary(tree.orders.murray.median)
          .whole(tree.orders.murray.forks)
          .whole(tree.orders.murray.infinite);
    }
    if (areas) add_ratios(row, tree.orders.mean_areas);
    table.add(std::move(row));
  }
  return table;
}

Table level_table() {
  return Table({"tree", "depth", "nodes", "external_nodes"});
}

void add_levels(Table& table, const RecordedTree& tree) {
  struct Level {
    std::uint64_t nodes = 0, external_nodes = 0;
  };
  const auto depth = depths(tree.tree);
  std::vector<Level> levels(*std::ranges::max_element(depth));
  for (std::size_t node = 0; node < depth.size(); ++node) {
    Level& level = levels[depth[node] - 1];
    ++level.nodes;
    if (tree.tree.arity(node) == 0) ++level.external_nodes;
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
    table.add(Row().text(tree.name).whole(i + 1).whole(levels[i].nodes).whole(levels[i].external_nodes));
}

Table node_table() {
  return Table({"tree", "node", "parent", "name", "leaf_order", "order", "horsfield", "horsfield_from_root",
                "depth", "magnitude", "main", "secondary", "length", "radius"});
}

void add_nodes(Table& table, const RecordedTree& tree, unsigned leaf_order) {
  const auto orders = strahler_orders(tree.tree);
  const auto horsfield = horsfield_orders(tree.tree), from_root = horsfield_orders_from_root(tree.tree);
  const auto depth = depths(tree.tree);
  const auto magnitude = magnitudes(tree.tree);
  const auto paths = path_nodes(tree.tree, MainChild::highest_order);
  const auto parents = parent_numbers(tree.tree);
  for (std::size_t node = 0; node < parents.size(); ++node) {
    Row row;
    row.text(tree.name).whole(node + 1).whole(parents[node]).text(tree.names[node]).whole(leaf_order);
    row.whole(orders[node] + leaf_order).whole(horsfield[node]).whole(from_root[node]).whole(depth[node]);
    row.whole(magnitude[node]).whole(paths[node].main).whole(paths[node].secondary);
    add_geometry(row, true, tree.lengths, node);
    add_geometry(row, true, tree.radii, node);
    table.add(std::move(row));
  }
}

}  // namespace ramify
