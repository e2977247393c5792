#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "ramify/accumulate/estimate.hpp"
#include "ramify/statistic/statistic_info.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// One column of a cell over those of its trees that have a value: a tree without an order has no ratio to
/// it.
struct ColumnSummary {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  StatisticColumn column;
  std::uint64_t trees = 0;
  double mean = none;  ///< none where no tree has a value
  double standard_error = none;
  double variance = none;
  double min = none, q05 = none, q50 = none, q95 = none, max = none;
  /// Value and number of trees; kept where there are at most histogram_values different whole values, else
  /// empty.
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::vector<std::pair<std::int64_t, std::uint64_t>> histogram = {};

  static constexpr std::size_t histogram_values = 64;
};

/// One order of a cell over its trees: mean counts, and the pooled ratio to the order above (NaN at the top).
struct OrderSummary {
  Estimate nodes, streams;
  Estimate nodes_pooled_ratio, streams_pooled_ratio;
};

/// What is kept of a finished cell: all that tables, plots and verdicts need.
struct CellResult {
  std::string model;
  Size n = 0;
  std::uint64_t replicates = 0;
  std::vector<ColumnSummary> columns;
  std::vector<OrderSummary> orders;  ///< orders 0.., where nodes or streams were asked for

  /// What is known of the column; throws std::out_of_range where it is not there (a claim's config must ask
  /// for it).
  const ColumnSummary& column(const StatisticColumn& column) const;
};

}  // namespace ramify
