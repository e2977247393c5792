#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ledger.hpp"
#include "program.hpp"

#include "ramify/config/run_config.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/run/work_folder.hpp"

namespace ramify::cli {

/// Options that `run` and `reproduce` share.
struct RunFlags {
  std::string out, seed, threads;
  bool resume = false, restart = false, dry_run = false, yes = false;

  void add_to(Verb& verb);

  /// Of --seed.
  std::optional<std::uint64_t> given_seed() const;

  /// Of --resume and --restart.
  KeptCells kept_cells() const;

  /// --out/<stem of the config>
  std::filesystem::path folder_of(const RunConfig& config) const;
};

/// What the configs would cost, for --dry-run.
void print_cost(const std::vector<RunConfig>& configs, unsigned threads);

/// Throws Error where the configs are not to be run as they are: too large without --yes, or for the memory,
/// or into folders that are not to be replaced.
/// @param threads  of this process
void require_runnable(const std::vector<RunConfig>& configs, const RunFlags& flags, unsigned threads);

/// Runs the configs, which are runnable, one after the other. Throws Interrupted, after saying
/// where the complete cells lie, when stopped.
Ledger run_configs(const std::vector<RunConfig>& configs, const RunFlags& flags, const Workforce& workforce,
                   GrowthLimits& limits, const Cancellation& cancellation);

/// What the other processes of a team do meanwhile, or where nothing is run: grow trees, and write nothing.
ExitCode help_run_configs(const std::vector<RunConfig>& configs, const RunFlags& flags,
                          const Workforce& workforce, const Cancellation& cancellation);

/// Says on standard error why pictures are missing, each reason once in a process; nothing where none is.
void warn_of_pictures(const std::string& why);

/// The verdicts on the claims. What could not be judged is said on standard error, part by part.
Ledger::Judged judge_claims(const Ledger& ledger, const std::vector<const Claim*>& claims, unsigned threads,
                            GrowthLimits& limits, const Cancellation& cancellation);

/// check_failed where a part that was declared has no verdict.
ExitCode delivered(const Ledger::Judged& judged);

/// Says how far the sampled means lie from their exact values; check_failed where it is too far.
ExitCode report_checks(const Ledger& ledger);

}  // namespace ramify::cli
