#pragma once

#include "ramify/measure/tree_measurement.hpp"
#include "ramify/statistic/statistic_info.hpp"

namespace ramify::detail {

/// Its value as a number, NaN where the tree has none or only counts of streams are known; orders are counted
/// from the leaf order.
double value_of(const StatisticColumn& column, const TreeMeasurement& tree, unsigned leaf_order);

}  // namespace ramify::detail
