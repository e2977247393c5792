#pragma once

#include "ledger.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/run/run.hpp"

namespace ramify {

/// Runs a config and adds its cells to the ledger; where it serves claims, verdicts.csv and their plots of
/// its own cells are written beside its tables. A run that was stopped is evidence of nothing. Throws
/// Interrupted where it is stopped while claims are judged.
RunOutcome run_and_judge(const RunConfig& config, const RunOptions& options, const Cancellation& cancellation,
                         Ledger& ledger, GrowthLimits& limits);

}  // namespace ramify
