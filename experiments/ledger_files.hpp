#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ledger_page.hpp"

namespace ramify {

/// What the claims draw from laws alone, in their order. Throws Interrupted. Cost: half a minute for all of
/// them, shared by the threads.
std::vector<NamedPlot> law_plots(const std::vector<const Claim*>& claims, GrowthLimits& limits,
                                 unsigned threads, const Cancellation& cancellation);

/// Writes what was reproduced into a folder: verdicts.csv and verdicts.txt, the claims' plots into plots/, of
/// every claim its verdicts, claims/C20.csv, and the numbers of its pictures, claims/C20_points.csv, and the
/// page about all of it, report.html. Returns why pictures are missing; nothing where all were drawn. Throws
/// Error where a file cannot be written.
/// @param plots  of its claims: names begin with the number of the claim
std::string write_ledger(const Reproduction& reproduction, std::vector<NamedPlot> plots,
                         const std::filesystem::path& folder);

}  // namespace ramify
