#include "ramify/experiment/registry_columns.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace ramify::detail {
namespace {

/// What follows from counts of streams alone.
bool reads_streams_alone(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{
      "magnitude",          "strahler",           "registers",         "streams",
      "streams_mean_ratio", "streams_regression", "streams_geometric", "streams_ratio"};
  return std::ranges::find(names, name) != names.end();
}

/// The k of T_k is a difference of orders.
bool counts_from_leaves(const StatisticInfo& statistic) {
  return statistic.shape != Columns::one && statistic.name != "tokunaga";
}

std::string column_name(const StatisticInfo& statistic, OrderPlace place, unsigned leaf_order) {
  if (statistic.shape == Columns::one) return std::string(statistic.name);
  const std::size_t shift = counts_from_leaves(statistic) ? leaf_order : 0;
  const bool pairs = statistic.shape == Columns::pairs || statistic.shape == Columns::lower_pairs;
  return pairs ? fmt::format("{}_{}_{}", statistic.name, place.high + shift, place.low + shift)
               : fmt::format("{}_{}", statistic.name, place.high + shift);
}

TreeMeasures measures_of_streams(const std::vector<std::uint64_t>& streams) {
  TreeMeasures measures;
  measures.strahler = static_cast<std::uint32_t>(streams.size() - 1);
  std::ranges::copy(streams, measures.streams.begin());
  return measures;
}

}  // namespace

std::vector<RegistryColumn> registry_columns(std::size_t largest_order, unsigned leaf_order) {
  std::vector<RegistryColumn> columns;
  for (const StatisticInfo& statistic : statistics())
    for (const OrderPlace place : statistic.places(largest_order))
      columns.push_back({column_name(statistic, place, leaf_order), &statistic, place});
  return columns;
}

double value_of(const RegistryColumn& column, const TreeMeasurement& tree, unsigned leaf_order) {
  const StatisticInfo& statistic = *column.statistic;
  if (!tree.measures && !reads_streams_alone(statistic.name)) return std::numeric_limits<double>::quiet_NaN();
  const StatisticValue value = statistic.value(
      tree.measures ? *tree.measures : measures_of_streams(tree.orders.streams), column.place);
  const double number = statistic.real ? value.real : static_cast<double>(value.whole);
  return statistic.is_order ? number + leaf_order : number;
}

}  // namespace ramify::detail
