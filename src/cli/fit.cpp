#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/fit/fit_table.hpp"
#include "ramify/fit/ratio_fitter.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct FitArguments {
  std::vector<std::string> files;
  std::string model = "patricia", observable = "ratio", n, seed = "1996", threads, format = "auto";
  Output output;
};

FitOptions fit_options(const FitArguments& options) {
  FitOptions fit;
  fit.model = &require_fittable(options.model);
  fit.seed = read_count("--seed", options.seed);
  fit.threads = read_threads(options.threads);
  if (!options.n.empty()) fit.n = read_count("--n", options.n);
  return fit;
}

void require_known(const FitArguments& options) {
  if (options.observable != "ratio")
    throw Error(fmt::format("--observable {}", options.observable),
                "only the bifurcation ratio is fitted so far", "take ratio");
  if (options.format != "auto" && options.format != "table" && options.format != "csv")
    throw Error(fmt::format("--format {}", options.format), "not a format that fit writes",
                "take table, csv, or auto");
}

ExitCode fit(const FitArguments& options, const Cancellation& cancellation) {
  require_known(options);
  std::vector<RatioDatum> data;
  for (const auto& file : options.files)
    for (auto& datum : read_ratio_data(file)) data.push_back(std::move(datum));
  RatioFitter fitter(fit_options(options), cancellation);
  const auto progress = progress_line("fit");
  std::vector<FitRow> rows;
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (const auto& warning : data[i].warnings) fmt::print(stderr, "ramify: warning: {}\n", warning);
    for (auto& row : fitter.fit(data[i])) rows.push_back(std::move(row));
    progress(static_cast<double>(i + 1), static_cast<double>(data.size()));
  }
  const bool read =
      options.format == "table" || (options.format == "auto" && options.output.is_for_reading());
  emit(read ? fit_text(rows) : write_csv(fit_table(rows)), options.output);
  return any_not_converged(rows) ? ExitCode::no_convergence : ExitCode::done;
}

}  // namespace

void add_fit(Program& program) {
  auto options = std::make_shared<FitArguments>();
  Verb verb = program.verb("fit", "Fit the split parameter of a model to measured bifurcation ratios");
  verb.option("data", options->files,
              "CSV: ratios (name,ratio,max_order,branches) or stream counts (order,count)", Need::required);
  verb.option("--model", options->model, "patricia or dst", Need::defaulted);
  verb.option("--observable", options->observable, "what is fitted: ratio", Need::defaulted);
  verb.option("--n", options->n, "internal nodes, in place of the size in the data");
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  verb.option("--threads", options->threads,
              "threads; all cores if left out. The result does not depend on it");
  verb.option("--format", options->format,
              "table (aligned, with notes) or csv; auto: table on a terminal, else csv", Need::defaulted);
  options->output.add_table_to(verb);
  verb.example("Example: ramify fit data/species.csv");
  verb.work([options](const Cancellation& cancellation) { return fit(*options, cancellation); });
}

}  // namespace ramify::cli
