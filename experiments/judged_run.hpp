#pragma once

#include <filesystem>

#include "ledger.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/run/run.hpp"

namespace ramify {

/// Runs a config and adds its cells to the ledger; where it serves claims, verdicts.csv and their plots of
/// its own cells are written beside its tables. A run that was stopped is evidence of nothing. Throws
/// Interrupted where it is stopped while claims are judged.
RunOutcome run_and_judge(const RunConfig& config, const RunOptions& options, const Cancellation& cancellation,
                         Ledger& ledger, GrowthLimits& limits);

/// Writes what the claims draw from laws alone to plots/ of a folder. Throws Interrupted. Cost: half a minute
/// for all of them, shared by the threads.
void write_law_plots(const std::vector<const Claim*>& claims, GrowthLimits& limits, unsigned threads,
                     const Cancellation& cancellation, const std::filesystem::path& folder);

}  // namespace ramify
