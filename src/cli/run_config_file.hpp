#pragma once

#include <filesystem>
#include <string>

#include "program.hpp"
#include "verdicts.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/run/run.hpp"

namespace ramify::cli {

/// Options that `run` and `reproduce` share.
struct RunFlags {
  std::string out, seed, threads;
  bool resume = false, dry_run = false, yes = false;

  void add_to(Verb& verb);
};

/// Nodes, minutes and memory of configs, as --dry-run prints them.
std::string describe_work(const std::vector<RunConfig>& configs, unsigned threads);

double total_nodes(const std::vector<RunConfig>& configs);

/// Runs one config into out/<stem of the config>, adds its cells to the evidence, and writes verdict.json and
/// the claims' plots of its own cells there. Throws Interrupted, after saying where the complete cells lie,
/// when stopped.
void run_config_file(const RunConfig& config, const RunFlags& flags, const Cancellation& cancellation,
                     Evidence& evidence);

/// Prints the warning and returns check_failed where a sampled mean lies too far from its exact value.
ExitCode judge_checks(const Evidence& evidence);

}  // namespace ramify::cli
