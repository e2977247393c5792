#pragma once

#include <vector>

#include "ramify/accumulate/order_totals.hpp"
#include "ramify/accumulate/real_summary.hpp"
#include "ramify/accumulate/whole_summary.hpp"

namespace ramify {

/// All that a run keeps of some trees of a cell. A value: it can be stored, sent, and merged with that of
/// other trees, without a difference to the last bit.
struct CellSums {
  std::vector<WholeSummary> wholes;  ///< of the columns of whole numbers, in their order
  std::vector<RealSummary> reals;    ///< of the others
  OrderTotals nodes, streams;        ///< where they were asked for

  /// The trees of `later` follow those of this one.
  void merge(const CellSums& later);

  friend bool operator==(const CellSums&, const CellSums&) = default;
};

}  // namespace ramify
