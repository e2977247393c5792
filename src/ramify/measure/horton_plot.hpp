#pragma once

#include <vector>

#include "ramify/measure/tree_measurement.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// The Horton diagram (Horton 1945): on a logarithmic axis, against the order, the number of streams of a
/// tree, and their mean length and radius where it has any; each with its least-squares line, whose ratio is
/// the `regression` of the tables. Of several trees the numbers of streams alone.
///
/// Throws Error for more than most_drawn_trees.
/// @param leaf_order  0 or 1: order of the external nodes
Plot horton_plot(const std::vector<MeasuredOrders>& trees, unsigned leaf_order);

inline constexpr std::size_t most_drawn_trees = 8;

}  // namespace ramify
