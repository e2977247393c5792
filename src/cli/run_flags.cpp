#include "run_flags.hpp"

#include <set>

#include "judged_run.hpp"
#include "session.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/run/run_cost.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

void run_config(const RunConfig& config, const RunFlags& flags, const Workforce& workforce,
                const ModelLooks& looks, const Cancellation& cancellation, Ledger& ledger,
                GrowthLimits& limits) {
  const auto folder = flags.folder_of(config);
  const RunOptions options{folder,
                           workforce,
                           flags.kept_cells(),
                           progress_line(folder.filename().string()),
                           [](const std::string& line) { fmt::print(stderr, "ramify: {}\n", line); },
                           looks};
  const RunOutcome outcome = run_and_judge(config, options, cancellation, ledger, limits);
  clear_progress_line();
  warn_of_pictures(outcome.no_pictures);
  if (outcome.finished) return;
  fmt::print(stderr,
             "ramify: {} of the cells are complete; they, and blocks of others, are kept in {}; continue "
             "with --resume\n",
             outcome.checked.cells.size(), outcome.folder.string());
  throw Interrupted();
}

}  // namespace

void RunFlags::add_to(Verb& verb) {
  verb.option("-o,--output,--out", out, "folder for the results", Need::defaulted);
  verb.option("--seed", seed, "use this seed in place of the configs'");
  verb.option("--threads", threads, "threads; all cores if left out. No result depends on it");
  const DeclaredOption resumed =
      verb.flag("--resume", resume, "take over the cells that an earlier run of the same config completed");
  Verb::exclude(resumed, verb.flag("--restart", restart, "drop the cells that a stopped run has kept"));
  verb.flag("--dry-run", dry_run, "say what it would cost (nodes, minutes, memory), and stop");
  verb.flag("--yes", yes, "allow more than 10^13 nodes");
}

std::optional<std::uint64_t> RunFlags::given_seed() const {
  if (seed.empty()) return std::nullopt;
  return read_count("--seed", seed);
}

KeptCells RunFlags::kept_cells() const {
  if (resume) return KeptCells::take_over;
  return restart ? KeptCells::drop : KeptCells::refuse;
}

std::filesystem::path RunFlags::folder_of(const RunConfig& config) const {
  return std::filesystem::path(out) / std::filesystem::path(config.path).stem();
}

void print_cost(const std::vector<RunConfig>& configs, unsigned threads) {
  emit(describe_cost(configs, threads));
}

void require_runnable(const std::vector<RunConfig>& configs, const RunFlags& flags, unsigned threads) {
  require_consent(total_nodes(configs), flags.yes);
  require_run_memory(configs, threads);
  for (const auto& config : configs) require_run_folder(flags.folder_of(config), flags.kept_cells());
}

void warn_of_pictures(const std::string& why) {
  static std::set<std::string> said;
  if (why.empty() || !said.insert(why).second) return;
  clear_progress_line();
  fmt::print(stderr, "ramify: warning: pictures are missing: {}; tables and reports are there\n", why);
}

Ledger run_configs(const std::vector<RunConfig>& configs, const RunFlags& flags, const Workforce& workforce,
                   GrowthLimits& limits, const Cancellation& cancellation) {
  ModelLooks looks;
  for (const auto& config : configs) looks.add(config);
  Ledger ledger(looks);
  for (const auto& config : configs)
    run_config(config, flags, workforce, looks, cancellation, ledger, limits);
  return ledger;
}

ExitCode help_run_configs(const std::vector<RunConfig>& configs, const RunFlags& flags,
                          const Workforce& workforce, const Cancellation& cancellation) {
  if (flags.dry_run) return ExitCode::done;
  for (const auto& config : configs) help_run_experiment(config, workforce, cancellation);
  return ExitCode::done;
}

Ledger::Judged judge_claims(const Ledger& ledger, const std::vector<const Claim*>& claims, unsigned threads,
                            GrowthLimits& limits, const Cancellation& cancellation) {
  if (claims.empty()) return {};
  show_progress("verdicts");
  Ledger::Judged judged = ledger.judged(claims, limits, threads, cancellation);
  clear_progress_line();
  for (const auto& failure : judged.failures) fmt::print(stderr, "ramify: {}\n", failure);
  return judged;
}

ExitCode delivered(const Ledger::Judged& judged) {
  return judged.failures.empty() ? ExitCode::done : ExitCode::check_failed;
}

ExitCode report_checks(const Ledger& ledger) {
  const auto [check, where] = ledger.worst_check();
  if (check.means == 0) return ExitCode::done;
  fmt::print(
      stderr,
      "{} sampled means held against exact finite-n laws: the worst is {:.1f} standard errors off ({})\n",
      check.means, check.worst_z, where);
  if (!check.failed()) return ExitCode::done;
  fmt::print(stderr,
             "ramify: a sampler disagrees with its exact law (more than {:.1f} standard errors): please "
             "report it\n",
             check.allowed_z);
  return ExitCode::check_failed;
}

}  // namespace ramify::cli
