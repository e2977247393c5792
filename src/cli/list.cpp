#include "claim.hpp"
#include "session.hpp"
#include "verbs.hpp"

#include "ramify/core/nearest_name.hpp"
#include "ramify/tabulate/list_tables.hpp"

namespace ramify::cli {
namespace {

Table table_of(const std::string& what) {
  if (what == "models") return model_table();
  if (what == "families") return family_table();
  if (what == "statistics") return statistic_table();
  if (what == "claims") return claim_table();
  if (what == "presets") return preset_table();
  if (what == "coverage") return coverage_table();
  throw Error("cannot list '" + what + "'", "there is no such list",
              did_you_mean(what, {"models", "families", "statistics", "claims", "presets", "coverage"}) +
                  "list models, families, statistics, claims, presets or coverage");
}

}  // namespace

void add_list(Program& program) {
  struct Options {
    std::string what;
    Output output;
  };
  auto options = std::make_shared<Options>();
  Verb verb = program.verb("list",
                           "List the models, families to fit, statistics, claims, presets, or what is known "
                           "of which statistic for which model");
  verb.option("what", options->what, "models, families, statistics, claims, presets or coverage",
              Need::required);
  options->output.add_table_to(verb);
  verb.example("Example: ramify list models");
  verb.work([options](const Cancellation&) {
    emit(table_of(options->what), options->output);
    return ExitCode::done;
  });
}

}  // namespace ramify::cli
