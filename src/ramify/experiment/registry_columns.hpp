#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ramify/experiment/tree_measurement.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify::detail {

/// A column of a table of measured trees: a statistic of the registry at an order, or the whole of it.
struct RegistryColumn {
  std::string name;  ///< orders in it are counted from the leaf order of the table
  const StatisticInfo* statistic;
  OrderPlace place;  ///< leaf order 0
};

/// The columns of all statistics for trees of orders 0..largest.
std::vector<RegistryColumn> registry_columns(std::size_t largest_order, unsigned leaf_order);

/// Its value as a number, NaN where the tree has none or only counts of streams are known; orders are counted
/// from the leaf order.
double value_of(const RegistryColumn& column, const TreeMeasurement& tree, unsigned leaf_order);

}  // namespace ramify::detail
