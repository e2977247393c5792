#include "ramify/measure/column_value.hpp"

#include <algorithm>
#include <limits>

namespace ramify::detail {
namespace {

TreeMeasures measures_of_streams(const std::vector<std::uint64_t>& streams) {
  TreeMeasures measures;
  measures.strahler = static_cast<std::uint32_t>(streams.size() - 1);
  std::ranges::copy(streams, measures.streams.begin());
  return measures;
}

}  // namespace

double value_of(const StatisticColumn& column, const TreeMeasurement& tree, unsigned leaf_order) {
  if (!tree.measures && !column.statistic->from_streams) return std::numeric_limits<double>::quiet_NaN();
  const double number =
      column.real_value(tree.measures ? *tree.measures : measures_of_streams(tree.orders.streams));
  return column.statistic->is_order ? number + leaf_order : number;
}

}  // namespace ramify::detail
