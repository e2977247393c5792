#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ramify/config/run_config.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/run/model_looks.hpp"
#include "ramify/run/run_tables.hpp"
#include "ramify/run/work_folder.hpp"

namespace ramify {

struct RunOptions {
  std::filesystem::path folder;  ///< of this run; made at the end, in one step, from "<folder>.incomplete"
  Workforce workforce = 1;
  KeptCells kept = KeptCells::refuse;  ///< of a stopped run; take_over: those of a finished run too
  std::function<void(double done, double total)> progress;  ///< nodes; may be empty
  /// A line: what is kept of an earlier run; may be empty.
  std::function<void(const std::string&)> say = {};  // NOLINT(readability-redundant-member-init): -Wextra
  ModelLooks looks = {};  ///< of the models of all configs that the command runs; may be empty
};

struct RunOutcome {
  CheckedRun checked;            ///< the cells that are complete, in the order of the plan
  bool finished;                 ///< false where the user stopped it
  std::filesystem::path folder;  ///< where the tables lie: options.folder, or "<folder>.incomplete"
  /// Why pictures are missing; empty where all were drawn.
  std::string no_pictures = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
};

/// Runs a config: grows the trees of all its cells, checks the means against exact laws, writes the tables,
/// plots, provenance and a page about all of it, report.html (run_page.hpp). Without gnuplot the page names
/// the pictures as missing.
///
/// Throws Error before any work where the folder cannot be written or is not to be replaced (WorkFolder), or
/// where what is to be taken over is of another plan (BlockStore). A run that is stopped, or killed, keeps
/// its blocks in "<folder>.incomplete"; one that is stopped writes tables of its complete cells there too,
/// with a provenance that says so.
RunOutcome run_experiment(const RunConfig& config, const RunOptions& options,
                          const Cancellation& cancellation);

/// What the other processes of a team do in run_experiment: grow trees, and write nothing. Throws
/// Interrupted.
void help_run_experiment(const RunConfig& config, const Workforce& workforce,
                         const Cancellation& cancellation);

}  // namespace ramify
