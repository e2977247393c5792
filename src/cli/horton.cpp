#include <memory>

#include "reading.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/fit/model_fits.hpp"
#include "ramify/horton/horton_table.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct HortonArguments {
  Reading reading;
  std::string model, trees = "400", seed = "1996", threads;
  Output output;
};

HortonOptions horton_options(const HortonArguments& options) {
  constexpr std::uint64_t fewest = 40;
  HortonOptions horton;
  horton.families =
      options.model.empty() ? one_parameter_families() : chosen_families(options.model, families());
  horton.trees = {read_count("--trees", options.trees), read_count("--seed", options.seed),
                  read_threads(options.threads)};
  if (horton.trees.trees < fewest)
    throw Error(fmt::format("--trees {}", options.trees), "fewer trees say little of how a ratio scatters",
                fmt::format("take {} or more", fewest));
  return horton;
}

ExitCode horton(const HortonArguments& options, const Cancellation& cancellation) {
  HortonOptions horton = horton_options(options);
  horton.progress = progress_line("horton");
  const MeasureRequest request = options.reading.request();
  const auto warn = [](const std::string& warning) { fmt::print(stderr, "ramify: warning: {}\n", warning); };
  const MeasuredFiles measured = measure_files(request, cancellation, warn);
  emit(horton_table(horton_laws(measured.orders, horton, cancellation), request.leaf_order), options.output);
  return ExitCode::done;
}

}  // namespace

void add_horton(Program& program) {
  auto options = std::make_shared<HortonArguments>();
  Verb verb = program.verb(
      "horton", "Horton's ratios of measured trees by every estimator, with errors, and Murray's exponent");
  options->reading.add_to(verb);
  verb.option("--model", options->model,
              "families, NAME[,NAME..] or all, the best of which gives errors; if left out all of one "
              "parameter. See: ramify list families");
  verb.option("--trees", options->trees, "trees of the fitted model that are grown for errors and bias",
              Need::defaulted);
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  add_threads(verb, options->threads);
  options->output.add_table_to(verb);
  verb.example("Example: ramify horton data/new_hope_creek.csv");
  verb.work([options](const Cancellation& cancellation) { return horton(*options, cancellation); });
}

}  // namespace ramify::cli
