#pragma once

#include <span>
#include <string>
#include <vector>

#include "ramify/statistic/statistic_info.hpp"

namespace ramify {

/// A choice of statistics, each once, in the order given.
class StatisticSet {
 public:
  StatisticSet() = default;
  explicit StatisticSet(std::vector<const StatisticInfo*> chosen) : chosen_(std::move(chosen)) {}

  /// Throws Error for an unknown name (nearest names given) or one given twice.
  static StatisticSet parse(std::span<const std::string> names);

  /// All of the registry.
  static StatisticSet all();

  const std::vector<const StatisticInfo*>& chosen() const { return chosen_; }
  bool contains(const StatisticInfo& statistic) const;

  /// What they are read off.
  FoldSet folds() const;

  /// The columns, those by orders up to K, the largest order that a tree of the model and size can have
  /// (Model::largest_order), so that a table's columns never depend on what was drawn.
  std::vector<StatisticColumn> columns(std::size_t largest_order) const;

 private:
  std::vector<const StatisticInfo*> chosen_;
};

/// The statistics of a measured tree, column by column.
void write_statistics(const std::vector<StatisticColumn>& columns, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row);

}  // namespace ramify
