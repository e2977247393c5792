#include "ramify/measure/registry_columns.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

namespace ramify::detail {
namespace {

/// What follows from counts of streams alone.
bool reads_streams_alone(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{
      "magnitude",          "strahler",           "registers",         "streams",
      "streams_mean_ratio", "streams_regression", "streams_geometric", "streams_ratio"};
  return std::ranges::find(names, name) != names.end();
}

TreeMeasures measures_of_streams(const std::vector<std::uint64_t>& streams) {
  TreeMeasures measures;
  measures.strahler = static_cast<std::uint32_t>(streams.size() - 1);
  std::ranges::copy(streams, measures.streams.begin());
  return measures;
}

}  // namespace

std::vector<StatisticSet::Column> registry_columns(std::size_t largest_order, unsigned leaf_order) {
  std::vector<StatisticSet::Column> columns;
  for (const StatisticInfo& statistic : statistics())
    for (const OrderPlace place : statistic.places(largest_order))
      columns.push_back({statistic.column_name(place, leaf_order), &statistic, place});
  return columns;
}

double value_of(const StatisticSet::Column& column, const TreeMeasurement& tree, unsigned leaf_order) {
  const StatisticInfo& statistic = *column.statistic;
  if (!tree.measures && !reads_streams_alone(statistic.name)) return std::numeric_limits<double>::quiet_NaN();
  const StatisticValue value = statistic.value(
      tree.measures ? *tree.measures : measures_of_streams(tree.orders.streams), column.place);
  const double number = as_real(column, value);
  return statistic.is_order ? number + leaf_order : number;
}

}  // namespace ramify::detail
