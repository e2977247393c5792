#include <set>

#include "run_config_file.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct Options {
  std::vector<std::string> configs;
  RunFlags flags;
};

std::vector<RunConfig> read_configs(const Options& options) {
  std::vector<RunConfig> configs;
  std::set<std::string> stems;
  for (const auto& path : options.configs) {
    configs.push_back(read_run_config(path));
    find_claims(configs.back().claim.value_or(""));
    if (!options.flags.seed.empty()) configs.back().seed = read_count("--seed", options.flags.seed);
    if (!stems.insert(std::filesystem::path(path).stem().string()).second)
      throw Error(fmt::format("config '{}'", path),
                  "another config has the same file name, and so the same folder",
                  "run them with different --out");
  }
  return configs;
}

ExitCode run(const Options& options, const Cancellation& cancellation) {
  const auto configs = read_configs(options);
  const unsigned threads = read_threads(options.flags.threads);
  if (options.flags.dry_run) {
    emit(describe_work(configs, threads), "");
    return ExitCode::done;
  }
  require_consent(total_nodes(configs), options.flags.yes);
  Evidence evidence;
  for (const auto& config : configs) run_config_file(config, options.flags, cancellation, evidence);
  const auto verdicts = evidence.verdicts();
  if (!verdicts.empty()) emit(verdict_text(verdicts), "");
  for (const auto& config : configs)
    fmt::print(
        stderr, "tables and plots: {}\n",
        (std::filesystem::path(options.flags.out) / std::filesystem::path(config.path).stem()).string());
  return judge_checks(evidence);
}

}  // namespace

void add_run(Program& program) {
  auto options = std::make_shared<Options>();
  options->flags.out = "results/runs";
  Verb verb = program.verb("run", "Run configs: grow, measure, compare, write tables and plots");
  verb.option("config", options->configs, "TOML files (docs/config.md)", Need::required);
  options->flags.add_to(verb);
  verb.example("Example: ramify run configs/quick/catalan_order.toml --out results/runs");
  verb.work([options](const Cancellation& cancellation) { return run(*options, cancellation); });
}

}  // namespace ramify::cli
