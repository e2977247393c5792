#pragma once

#include <string>
#include <vector>

#include "ramify/measure/tree_measurement.hpp"

namespace ramify {

/// `tree,leaf_order,order,nodes,streams[,mean_length][,mean_radius]`: a row for every order of every tree,
/// the geometry where any tree has it. @param leaf_order  0 or 1: order of the external nodes
std::string orders_table(const std::vector<MeasuredOrders>& trees, unsigned leaf_order);

/// A row for every tree: every statistic of the registry, the pooled ratios, and where any tree has geometry
/// the ratios of Horton's second law and Murray's exponent. Statistics by orders count them from leaf_order.
std::string summary_table(const std::vector<TreeMeasurement>& trees, unsigned leaf_order);

/// The header of level_rows.
std::string level_header();

/// The profile of the tree: a row for every depth, the root's being 1, with its nodes and the external ones
/// among them.
std::string level_rows(const RecordedTree& tree);

/// The header of node_rows.
std::string node_header();

/// A row for every node, in preorder from 1, parent 0 for the root: its order, labels of
/// statistic/node_labels.hpp, length and radius.
std::string node_rows(const RecordedTree& tree, unsigned leaf_order);

}  // namespace ramify
