#include <algorithm>
#include <iterator>
#include <utility>

#include "config_folder.hpp"
#include "ledger_files.hpp"
#include "run_flags.hpp"
#include "served_configs.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include "verdicts.hpp"
#include <fmt/format.h>

#include "ramify/io/atomic_file.hpp"
#include "ramify/page/shell_word.hpp"

namespace ramify::cli {
namespace {

namespace fs = std::filesystem;

struct ReproduceArguments {
  std::string scale = "quick", claim, configs;
  RunFlags flags;
};

/// The claims of --claim, else all.
std::vector<const Claim*> asked_for(const ReproduceArguments& options) {
  const auto asked = find_claims(options.claim);
  return asked.empty() ? claims() : asked;
}

std::vector<RunConfig> configs_of(const ReproduceArguments& options) {
  if (options.scale != "quick" && options.scale != "full")
    throw Error(fmt::format("--scale {}", options.scale), "there is no such scale",
                "take quick (minutes) or full");
  auto configs = serving(
      read_configs(config_files(config_folder(options.configs, options.scale)), options.flags.given_seed()),
      find_claims(options.claim));
  if (configs.empty() && std::ranges::any_of(asked_for(options), &Claim::takes_trees))
    throw Error(fmt::format("nothing to run at scale {}", options.scale),
                "no config serves what was asked for", "see: ramify list claims");
  return configs;
}

/// Says which verdicts differ from the committed ones, results/reference/<scale>/verdicts.csv beside the
/// configs; with the configs' own seeds none should.
ExitCode compare_with_reference(const ReproduceArguments& options, const std::vector<Verdict>& verdicts) {
  const fs::path reference = config_folder(options.configs, options.scale) / "../../results/reference" /
                             options.scale / "verdicts.csv";
  if (!options.flags.seed.empty() || !fs::exists(reference)) return ExitCode::done;
  std::vector<std::string_view> narrowed_to;
  for (const Claim* claim : find_claims(options.claim)) narrowed_to.push_back(claim->id);
  const auto changed = changed_verdicts(verdicts, reference, narrowed_to);
  for (const auto& line : changed) fmt::print(stderr, "ramify: a committed verdict changed: {}\n", line);
  return changed.empty() ? ExitCode::done : ExitCode::check_failed;
}

/// What the command was beside --scale and --claim, as far as it decides a number.
std::string deciding_options(const ReproduceArguments& options) {
  std::string text;
  if (!options.configs.empty()) text += " --configs " + shell_word(options.configs);
  if (!options.flags.seed.empty()) text += " --seed " + shell_word(options.flags.seed);
  return text;
}

/// The last line names the page.
void say_where(const fs::path& out) {
  fmt::print(stderr,
             "verdicts: {0}/verdicts.csv, claim by claim {0}/claims\nplots:    {0}/plots\n"
             "tables:   {0}/<config>/summary.csv\nreport:   {0}/report.html\n",
             out.string());
}

ExitCode reproduce(const ReproduceArguments& options, Team* team, const Cancellation& cancellation) {
  const Workforce workforce = read_workforce(options.flags.threads, team);
  const auto configs = configs_of(options);
  if (!workforce.leads()) return help_run_configs(configs, options.flags, workforce, cancellation);
  if (options.flags.dry_run) {
    print_cost(configs, workforce.threads);
    return ExitCode::done;
  }
  require_runnable(configs, options.flags, workforce.threads);
  const fs::path out = options.flags.out;
  require_writable_folder(out / "plots");  // where the verdicts and their plots go in the end
  GrowthLimits limits;
  const Ledger ledger = run_configs(configs, options.flags, workforce, limits, cancellation);
  const Reproduction reproduction{
      options.scale,
      options.claim,
      deciding_options(options),
      configs,
      asked_for(options),
      judge_claims(ledger, asked_for(options), workforce.threads, limits, cancellation),
      sample_trees(asked_for(options), options.flags.given_seed().value_or(default_seed), cancellation)};
  std::vector<NamedPlot> plots = ledger.plots();
  std::ranges::move(law_plots(asked_for(options), limits, workforce.threads, cancellation),
                    std::back_inserter(plots));
  warn_of_pictures(write_ledger(reproduction, std::move(plots), out));
  const auto& judged = reproduction.judged;
  emit(verdict_text(judged.verdicts));
  const ExitCode code =
      std::max({report_checks(ledger), delivered(judged), compare_with_reference(options, judged.verdicts)});
  say_where(out);
  return code;
}

}  // namespace

void add_reproduce(Program& program) {
  auto options = std::make_shared<ReproduceArguments>();
  options->flags.out = "results/runs/reproduce";
  Verb verb = program.verb("reproduce", "Run every config of a scale and print the verdict on every claim");
  verb.option("--scale", options->scale, "quick (minutes) or full", Need::defaulted);
  verb.option("--claim", options->claim, "only the configs that serve this claim; see: ramify list claims");
  verb.option("--configs", options->configs, "folder with quick/ and full/");
  options->flags.add_to(verb);
  verb.example("Example: ramify reproduce --scale quick --claim C22");
  verb.team_work([options](Team* team, const Cancellation& cancellation) {
    return reproduce(*options, team, cancellation);
  });
}

}  // namespace ramify::cli
