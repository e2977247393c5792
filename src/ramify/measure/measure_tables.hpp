#pragma once

#include <optional>
#include <vector>

#include "ramify/io/table.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {

/// `tree,leaf_order,order,nodes,streams[,mean_length][,mean_radius][,mean_area]`: a row for every order of
/// every tree, the geometry where any tree has it. @param leaf_order  0 or 1: order of the external nodes
Table orders_table(const std::vector<MeasuredOrders>& trees, unsigned leaf_order);

/// A row for every tree: every statistic of the registry, the pooled ratios, and where any tree has geometry
/// the ratios of Horton's second law and Murray's exponent. Statistics by orders count them from leaf_order.
/// @param chosen  these statistics alone, and nothing else
Table summary_table(const std::vector<TreeMeasurement>& trees, unsigned leaf_order,
                    const std::optional<StatisticSet>& chosen);

/// What add_levels adds to: no rows yet.
Table level_table();

/// The profile of the tree: a row for every depth, the root's being 1, with its nodes and the external ones
/// among them.
void add_levels(Table& table, const RecordedTree& tree);

/// What add_nodes adds to: no rows yet.
Table node_table();

/// A row for every node, in preorder from 1, parent 0 for the root: its order, labels of
/// statistic/node_labels.hpp, length and radius.
void add_nodes(Table& table, const RecordedTree& tree, unsigned leaf_order);

}  // namespace ramify
