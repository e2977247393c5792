#include <algorithm>

#include "run_flags.hpp"
#include "served_configs.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include "verdicts.hpp"
#include <fmt/format.h>

namespace ramify::cli {
namespace {

struct RunArguments {
  std::vector<std::string> configs;
  RunFlags flags;
};

ExitCode run(const RunArguments& options, Team* team, const Cancellation& cancellation) {
  const Workforce workforce = read_workforce(options.flags.threads, team);
  const auto configs =
      read_configs({options.configs.begin(), options.configs.end()}, options.flags.given_seed());
  if (!workforce.leads()) return help_run_configs(configs, options.flags, workforce, cancellation);
  if (options.flags.dry_run) {
    print_cost(configs, workforce.threads);
    return ExitCode::done;
  }
  require_runnable(configs, options.flags, workforce.threads);
  GrowthLimits limits;
  const Ledger ledger = run_configs(configs, options.flags, workforce, limits, cancellation);
  const auto judged = judge_claims(ledger, ledger.served(), workforce.threads, limits, cancellation);
  if (!judged.verdicts.empty()) emit(verdict_text(judged.verdicts));
  const ExitCode code = std::max(report_checks(ledger), delivered(judged));
  for (const auto& config : configs)
    fmt::print(stderr, "tables and plots: {0}\nreport:           {0}/report.html\n",
               options.flags.folder_of(config).string());
  return code;
}

}  // namespace

void add_run(Program& program) {
  auto options = std::make_shared<RunArguments>();
  options->flags.out = "results/runs";
  Verb verb = program.verb("run", "Run configs: grow, measure, compare, write tables, plots and a page");
  verb.option("config", options->configs, "TOML files (docs/config.md)", Need::required);
  options->flags.add_to(verb);
  verb.example("Example: ramify run configs/quick/catalan_order.toml --out results/runs");
  verb.team_work(
      [options](Team* team, const Cancellation& cancellation) { return run(*options, team, cancellation); });
}

}  // namespace ramify::cli
