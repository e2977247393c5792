#pragma once

#include <vector>

#include "ramify/run/cell_result.hpp"
#include "ramify/run/cell_sums.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

/// Sums up the trees of one block of replicates, or of a whole cell once the blocks are merged in order.
class CellAccumulator {
 public:
  /// @param largest_order  of the cell's trees
  CellAccumulator(const StatisticSet& statistics, std::size_t largest_order);

  void add(const TreeMeasures& measures);
  /// The trees of `later`, of the same statistics and largest order, follow those of this one.
  void merge(const CellSums& later) { sums_.merge(later); }

  const CellSums& sums() const { return sums_; }
  CellResult result(const Cell& cell) const;

 private:
  std::vector<ColumnSummary> summarise() const;
  std::vector<OrderSummary> summarise_orders() const;

  std::vector<StatisticColumn> columns_;
  bool counts_orders_;
  std::vector<StatisticValue> row_;
  std::vector<std::size_t> slot_;  // of each column: index into the whole or the real sums
  CellSums sums_;
};

}  // namespace ramify
