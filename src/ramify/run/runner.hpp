#pragma once

#include <functional>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/run/block_store.hpp"
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

/// Grows the trees of all cells that the store has not yet, in blocks of replicates handed to the threads, of
/// this process and of those that help it; every block is kept when it is grown.
///
/// A cell's result depends on (seed, model, n, replicates, statistics, graft) alone: blocks are a fixed
/// function of model, n and method, every replicate has its own stream, and blocks are merged in order.
/// Every complete cell is reported, those that were kept at once. Returns false where it was cancelled.
/// Throws Error where the store cannot be written. @param workforce  that many threads run, however few the
/// cores
bool run_cells(const Plan& plan, BlockStore& store, const Workforce& workforce,
               const Cancellation& cancellation, const RunObserver& observer);

/// What the other processes of a team do while one runs cells: grow blocks of the same plan and hand them
/// over. Throws Interrupted.
void help_run_cells(const Plan& plan, const Workforce& workforce, const Cancellation& cancellation);

}  // namespace ramify
