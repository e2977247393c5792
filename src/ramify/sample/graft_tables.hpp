#pragma once

#include <memory>

#include "ramify/core/cancellation.hpp"
#include "ramify/law/graft_table.hpp"
#include "ramify/sample/folds.hpp"
#include "ramify/sample/mean_counts_table.hpp"

namespace ramify {

/// The table from which a fold's grafts are drawn.
template <class F>
struct GraftTableFor {
  using Type = GraftTable<typename F::Value, TallyOf<F>>;
};
template <>
struct GraftTableFor<MeanCounts> {
  using Type = MeanCountsTable;
};
template <class F>
using GraftTableOf = typename GraftTableFor<F>::Type;

/// The graft table of a fold, sizes 0..largest: from the statistic's own law where the fold is one statistic,
/// from the generic engine where it is a joint one; for MeanCounts from the law of the order and the mean
/// counts given it. A second or so for the sizes of GraftRule. Throws Interrupted when cancelled.
/// @tparam F  Strahler, Height, FillLevel, Balance, MeanCounts, OrdersAndHeight or OrdersAndPaths
template <class F>
std::shared_ptr<const GraftTableOf<F>> make_graft_table(const Model& model, Size largest,
                                                        const Cancellation& cancellation);

}  // namespace ramify
