#pragma once

#include <functional>

#include "ramify/core/cancellation.hpp"
#include "ramify/run/cell_result.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {

/// What a run tells while it works. Both are called by one thread at a time.
struct RunObserver {
  /// Cell `index` of the plan is complete.
  std::function<void(std::size_t index, const CellResult&)> cell_done;
  /// Nodes grown so far, counted as WorkEstimate does.
  std::function<void(double nodes)> progress;
};

/// Grows the trees of the cells for which wanted[index] is true, in blocks of replicates handed to the
/// threads by one atomic counter.
///
/// A cell's result depends on (seed, model, n, replicates, statistics, graft) alone: blocks are a fixed
/// function of model, n and method, every replicate has its own stream, and blocks are merged in order.
/// Returns false where it was cancelled; cells that were complete have been reported. @param threads  >= 1;
/// that many run, however few the cores
bool run_cells(const Plan& plan, const std::vector<bool>& wanted, unsigned threads,
               const Cancellation& cancellation, const RunObserver& observer);

}  // namespace ramify
