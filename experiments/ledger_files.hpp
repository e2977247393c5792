#pragma once

#include <filesystem>
#include <string>

#include "ledger.hpp"
#include "ledger_page.hpp"

namespace ramify {

/// Writes what was reproduced into a folder: verdicts.csv and verdicts.txt, the claims' plots into plots/, of
/// every claim its verdicts, claims/C20.csv, and the numbers of its pictures, claims/C20_points.csv, and the
/// page about all of it, report.html. Returns why pictures are missing; nothing where all were drawn. Throws
/// Error where a file cannot be written.
/// @param ledger  what the verdicts are of
std::string write_ledger(const Reproduction& reproduction, const Ledger& ledger,
                         const std::filesystem::path& folder);

}  // namespace ramify
