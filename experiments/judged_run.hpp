#pragma once

#include <filesystem>

#include "evidence.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/run/run.hpp"

namespace ramify {

/// Runs a config and adds its cells to the evidence; where it serves claims, verdict.json and their plots of
/// its own cells are written beside its tables. A run that was stopped is evidence of nothing.
RunOutcome run_and_judge(const RunConfig& config, const RunOptions& options, const Cancellation& cancellation,
                         Evidence& evidence);

/// Writes verdicts.csv, verdicts.txt and the claims' plots, plots/*, into a folder.
void write_verdicts(const Evidence& evidence, const std::filesystem::path& folder);

}  // namespace ramify
