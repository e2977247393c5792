#include "ramify/statistic/statistic_set.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/find_named.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

StatisticSet StatisticSet::parse(std::span<const std::string> names) {
  StatisticSet set;
  for (const auto& name : names) {
    const StatisticInfo& info = find_named(statistics(), &StatisticInfo::name, name, "statistic");
    if (set.contains(info))
      throw Error(fmt::format("statistic '{}' given twice", name), "each becomes one set of columns",
                  "name it once");
    set.chosen_.push_back(&info);
  }
  if (set.chosen_.empty())
    throw Error("no statistic", "there is nothing to measure",
                "name one or more; see: ramify list statistics");
  return set;
}

StatisticSet StatisticSet::all() {
  StatisticSet set;
  for (const StatisticInfo& info : statistics()) set.chosen_.push_back(&info);
  return set;
}

bool StatisticSet::contains(const StatisticInfo& statistic) const {
  return std::ranges::find(chosen_, &statistic) != chosen_.end();
}

FoldSet StatisticSet::folds() const {
  FoldSet folds;
  for (const auto* info : chosen_) folds = folds | info->folds;
  return folds;
}

std::vector<StatisticColumn> StatisticSet::columns(std::size_t largest_order) const {
  std::vector<StatisticColumn> columns;
  for (const auto* info : chosen_)
    for (const OrderPlace place : info->places(largest_order)) columns.emplace_back(*info, place);
  return columns;
}

void write_statistics(const std::vector<StatisticColumn>& columns, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row) {
  row.clear();
  for (const auto& column : columns) row.push_back(column.value(measures));
}

}  // namespace ramify
