#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ramify/measure/tree_measurement.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify::detail {

/// The columns of all statistics for trees of orders 0..largest; orders in their names are counted from
/// leaf_order.
std::vector<StatisticSet::Column> registry_columns(std::size_t largest_order, unsigned leaf_order);

/// Its value as a number, NaN where the tree has none or only counts of streams are known; orders are counted
/// from the leaf order.
double value_of(const StatisticSet::Column& column, const TreeMeasurement& tree, unsigned leaf_order);

}  // namespace ramify::detail
