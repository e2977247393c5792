#include "run_config_file.hpp"

#include <algorithm>
#include <cmath>

#include "session.hpp"
#include <fmt/format.h>

#include "ramify/io/atomic_file.hpp"
#include "ramify/run/plan.hpp"

namespace ramify::cli {
namespace {

// Some thousand means are checked in a full reproduction: six standard errors is one false alarm in half a
// million runs.
constexpr double alarming_z = 6;

void write_plots(const std::vector<NamedPlot>& plots, const std::filesystem::path& folder) {
  for (const auto& named : plots) write_plot(named.plot, folder, named.stem);
}

}  // namespace

void RunFlags::add_to(Verb& verb) {
  verb.option("--out", out, "folder for the results", Need::defaulted);
  verb.option("--seed", seed, "use this seed in place of the configs'");
  verb.option("--threads", threads, "threads; all cores if left out. No result depends on it");
  verb.flag("--resume", resume, "take over the cells that an earlier run of the same config completed");
  verb.flag("--dry-run", dry_run, "say what it would cost (nodes, minutes, memory), and stop");
  verb.flag("--yes", yes, "allow more than 10^13 nodes");
}

double total_nodes(const std::vector<RunConfig>& configs) {
  double nodes = 0;
  for (const auto& config : configs) nodes += estimate_work(make_plan(config), 1).nodes;
  return nodes;
}

std::string describe_work(const std::vector<RunConfig>& configs, unsigned threads) {
  std::string text;
  WorkEstimate total{0, 0, 0};
  for (const auto& config : configs) {
    const Plan plan = make_plan(config);
    const WorkEstimate work = estimate_work(plan, threads);
    text += fmt::format("{}: {} cells, {:.3g} nodes, about {:.1f} minutes on {} threads, {:.0f} MB\n",
                        config.path, plan.cells.size(), work.nodes, work.minutes, threads, work.megabytes);
    total = {total.nodes + work.nodes, total.minutes + work.minutes,
             std::max(total.megabytes, work.megabytes)};
  }
  return text + fmt::format("in all {:.3g} nodes, about {:.1f} minutes, {:.0f} MB\n", total.nodes,
                            total.minutes, total.megabytes);
}

void run_config_file(const RunConfig& config, const RunFlags& flags, const Cancellation& cancellation,
                     Evidence& evidence) {
  const auto served = find_claims(config.claim.value_or(""));
  const std::string stem = std::filesystem::path(config.path).stem().string();
  const RunOptions options{std::filesystem::path(flags.out) / stem, read_threads(flags.threads), flags.resume,
                           progress_line(stem)};
  const RunOutcome outcome = run_experiment(config, options, cancellation);
  clear_progress_line();
  if (!outcome.finished) {
    fmt::print(stderr, "ramify: {} of the cells are complete and kept in {}; continue with --resume\n",
               outcome.cells.size(), outcome.folder.string());
    throw Interrupted();
  }
  Evidence own;
  own.add(served, outcome.cells);
  evidence.add(served, outcome.cells);
  if (served.empty()) return;
  write_file_atomically(outcome.folder / "verdict.json", verdict_json(own.verdicts()));
  write_plots(own.plots(), outcome.folder / "plots");
}

ExitCode judge_checks(const Evidence& evidence) {
  const auto worst = evidence.worst_check();
  if (!worst) return ExitCode::done;
  fmt::print(
      stderr,
      "{} sampled means held against exact finite-n laws: the worst is {:.1f} standard errors off ({})\n",
      worst->checks, worst->z, worst->where);
  if (worst->z < alarming_z) return ExitCode::done;
  fmt::print(
      stderr,
      "ramify: a sampler disagrees with its exact law (more than {} standard errors): please report it\n",
      alarming_z);
  return ExitCode::check_failed;
}

}  // namespace ramify::cli
