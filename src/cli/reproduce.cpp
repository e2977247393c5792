#include <algorithm>

#include "run_config_file.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string scale = "quick", claim, configs;
  RunFlags flags;
};

/// configs/ of --configs, of the working directory, or of the place ramify was built or installed from.
fs::path config_folder(const Options& options) {
  if (!options.configs.empty()) return fs::path(options.configs) / options.scale;
  for (const char* base : {"configs", RAMIFY_SOURCE_CONFIGS, RAMIFY_INSTALLED_CONFIGS})
    if (fs::is_directory(fs::path(base) / options.scale)) return fs::path(base) / options.scale;
  throw Error("no configs found", "neither ./configs nor the place ramify was built from has them",
              "name the folder with --configs");
}

bool serves(const RunConfig& config, const std::string& claim) {
  const auto served = find_claims(config.claim.value_or(""));
  return claim.empty() ||
         std::any_of(served.begin(), served.end(), [&](const Claim* c) { return c->id == claim; });
}

std::vector<RunConfig> read_configs(const Options& options) {
  if (options.scale != "quick" && options.scale != "full")
    throw Error(fmt::format("--scale {}", options.scale), "there is no such scale",
                "take quick (minutes) or full");
  find_claims(options.claim);
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(config_folder(options)))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<RunConfig> configs;
  for (const auto& path : paths) {
    RunConfig config = read_run_config(path);
    if (!options.flags.seed.empty()) config.seed = read_count("--seed", options.flags.seed);
    if (serves(config, options.claim)) configs.push_back(std::move(config));
  }
  if (configs.empty())
    throw Error(fmt::format("nothing to run at scale {}", options.scale),
                "no config serves what was asked for", "see: ramify list claims");
  return configs;
}

/// Says which verdicts differ from the committed ones, results/reference/<scale>/verdicts.csv beside the
/// configs; with the configs' own seeds none should.
ExitCode compare_with_reference(const Options& options, const std::vector<Verdict>& verdicts) {
  const fs::path reference =
      config_folder(options) / "../../results/reference" / options.scale / "verdicts.csv";
  if (!fs::exists(reference)) return ExitCode::done;
  const auto changed = changed_verdicts(verdicts, reference);
  for (const auto& line : changed) fmt::print(stderr, "ramify: a committed verdict changed: {}\n", line);
  return changed.empty() ? ExitCode::done : ExitCode::check_failed;
}

ExitCode reproduce(const Options& options, const Cancellation& cancellation) {
  const auto configs = read_configs(options);
  const unsigned threads = read_threads(options.flags.threads);
  if (options.flags.dry_run) {
    emit(describe_work(configs, threads), "");
    return ExitCode::done;
  }
  require_consent(total_nodes(configs), options.flags.yes);
  const fs::path out = options.flags.out;
  require_writable_folder(out / "plots");
  Evidence evidence;
  for (const auto& config : configs) run_config_file(config, options.flags, cancellation, evidence);
  const auto verdicts = evidence.verdicts();
  write_file_atomically(out / "verdicts.csv", write_csv(verdict_table(verdicts)));
  for (const auto& named : evidence.plots()) write_plot(named.plot, out / "plots", named.stem);
  write_file_atomically(out / "verdicts.txt", verdict_text(verdicts));
  emit(verdict_text(verdicts), "");
  fmt::print(stderr, "verdicts: {0}/verdicts.csv\nplots:    {0}/plots\ntables:   {0}/<config>/summary.csv\n",
             out.string());
  const ExitCode checks = judge_checks(evidence);
  return options.flags.seed.empty() ? std::max(checks, compare_with_reference(options, verdicts)) : checks;
}

}  // namespace

void add_reproduce(Program& program) {
  auto options = std::make_shared<Options>();
  options->flags.out = "results/runs/reproduce";
  Verb verb = program.verb("reproduce", "Run every config of a scale and print the verdict on every claim");
  verb.option("--scale", options->scale, "quick (minutes) or full", Need::defaulted);
  verb.option("--claim", options->claim, "only the configs that serve this claim; see: ramify list claims");
  verb.option("--configs", options->configs, "folder with quick/ and full/");
  options->flags.add_to(verb);
  verb.example("Example: ramify reproduce --scale quick --claim C22");
  verb.work([options](const Cancellation& cancellation) { return reproduce(*options, cancellation); });
}

}  // namespace ramify::cli
