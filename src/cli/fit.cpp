#include <algorithm>
#include <array>
#include <memory>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/fit/fit_table.hpp"
#include "ramify/fit/model_fit_table.hpp"
#include "ramify/fit/model_fits.hpp"
#include "ramify/fit/ratio_fitter.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct FitArguments {
  std::vector<std::string> files;
  std::string model, observable = "auto", n, seed = "1996", bootstrap = "0", threads, format = "auto";
  Output output;
};

/// What a file is fitted by.
enum class Observable { ratio, orders };

Observable observable_of(const FitArguments& options, const std::string& text) {
  if (options.observable == "ratio") return Observable::ratio;
  if (options.observable == "orders") return Observable::orders;
  return is_order_table(text) ? Observable::orders : Observable::ratio;
}

/// The one observable of all files: tables of the two have different columns.
Observable observable_of(const FitArguments& options, const std::vector<std::string>& texts) {
  const Observable first = observable_of(options, texts.front());
  for (std::size_t i = 1; i < texts.size(); ++i)
    if (observable_of(options, texts[i]) != first)
      throw Error(fmt::format("{} and {}", options.files[0], options.files[i]),
                  "one holds ratios and the other counts of streams",
                  "fit them one by one, or add --observable ratio");
  return first;
}

FitOptions ratio_options(const FitArguments& options) {
  FitOptions fit;
  fit.model = &require_fittable(options.model.empty() ? "patricia" : options.model);
  fit.seed = read_count("--seed", options.seed);
  fit.threads = read_threads(options.threads);
  if (!options.n.empty()) fit.n = read_count("--n", options.n);
  return fit;
}

void require_known(const FitArguments& options) {
  constexpr std::array<std::string_view, 3> observables{"auto", "ratio", "orders"};
  if (std::ranges::find(observables, options.observable) == observables.end())
    throw Error(fmt::format("--observable {}", options.observable), "not an observable that fit knows",
                "take ratio, orders, or auto");
  if (options.format != "auto" && options.format != "table" && options.format != "csv")
    throw Error(fmt::format("--format {}", options.format), "not a format that fit writes",
                "take table, csv, or auto");
}

bool is_for_reading(const FitArguments& options) {
  return options.format == "table" || (options.format == "auto" && options.output.is_for_reading());
}

ExitCode fit_ratios(const FitArguments& options, const std::vector<std::string>& texts,
                    const Cancellation& cancellation) {
  if (options.bootstrap != "0")
    throw Error(fmt::format("--bootstrap {}", options.bootstrap), "a ratio is fitted by simulation already",
                "leave it out, or give counts of streams");
  std::vector<RatioDatum> data;
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (auto& datum : parse_ratio_data(texts[i], options.files[i])) data.push_back(std::move(datum));
  RatioFitter fitter(ratio_options(options), cancellation);
  const auto progress = progress_line("fit");
  std::vector<FitRow> rows;
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (const auto& warning : data[i].warnings) fmt::print(stderr, "ramify: warning: {}\n", warning);
    for (auto& row : fitter.fit(data[i])) rows.push_back(std::move(row));
    progress(static_cast<double>(i + 1), static_cast<double>(data.size()));
  }
  emit(is_for_reading(options) ? fit_text(rows) : write_csv(fit_table(rows)), options.output);
  return any_not_converged(rows) ? ExitCode::no_convergence : ExitCode::done;
}

ModelFitOptions model_options(const FitArguments& options) {
  if (!options.n.empty())
    throw Error(fmt::format("--n {}", options.n), "a table of counts says its n itself: tips less one",
                "leave it out, or fit the ratio with --observable ratio");
  ModelFitOptions fit;
  fit.families = chosen_families(options.model.empty() ? "all" : options.model);
  fit.bootstrap_trees = read_count("--bootstrap", options.bootstrap);
  if (fit.bootstrap_trees == 1 || (fit.bootstrap_trees > 0 && fit.bootstrap_trees < 40))
    throw Error(fmt::format("--bootstrap {}", fit.bootstrap_trees),
                "2.5 and 97.5 % of fewer than 40 trees are their ends", "take 40 trees or more, say 1000");
  fit.seed = read_count("--seed", options.seed);
  fit.threads = read_threads(options.threads);
  fit.progress = progress_line("fit");
  return fit;
}

ExitCode fit_orders(const FitArguments& options, const std::vector<std::string>& texts,
                    const Cancellation& cancellation) {
  const ModelFitOptions fit = model_options(options);
  std::vector<FittedDatum> data;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto tables = read_order_counts(SourceText(texts[i], options.files[i]));
    for (const auto& table : tables)
      for (const auto& warning : table.warnings) fmt::print(stderr, "ramify: warning: {}\n", warning);
    for (auto& datum : fit_order_counts(tables, options.files[i], fit, cancellation))
      data.push_back(std::move(datum));
  }
  const Table table = model_fit_table(data);
  if (is_for_reading(options))
    emit(model_fit_text(data), options.output);
  else
    emit(write_csv(table), options.output);
  return any_not_converged(data) ? ExitCode::no_convergence : ExitCode::done;
}

ExitCode fit(const FitArguments& options, const Cancellation& cancellation) {
  require_known(options);
  std::vector<std::string> texts;
  for (const auto& file : options.files) texts.push_back(read_tree_file(file));
  return observable_of(options, texts) == Observable::ratio ? fit_ratios(options, texts, cancellation)
                                                            : fit_orders(options, texts, cancellation);
}

}  // namespace

void add_fit(Program& program) {
  auto options = std::make_shared<FitArguments>();
  Verb verb =
      program.verb("fit", "Fit models to measured trees: to counts of streams, or to a bifurcation ratio");
  verb.option("data", options->files,
              "CSV: stream counts (order,count) or ratios (name,ratio,max_order,branches)", Need::required);
  verb.option("--model", options->model,
              "families to fit, NAME[,NAME..] or all; see: ramify list families. Of a ratio patricia or dst");
  verb.option(
      "--observable", options->observable,
      "what is fitted: orders (counts of streams by their likelihood), ratio; auto: what the file holds",
      Need::defaulted);
  verb.option("--bootstrap", options->bootstrap,
              "trees of every fitted model that are fitted again: intervals, bias, goodness",
              Need::defaulted);
  verb.option("--n", options->n, "internal nodes, in place of the size in a table of ratios");
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  verb.option("--threads", options->threads,
              "threads; all cores if left out. The result does not depend on it");
  verb.option("--format", options->format,
              "table (aligned, with notes) or csv; auto: table on a terminal, else csv", Need::defaulted);
  options->output.add_table_to(verb);
  verb.example("Example: ramify fit data/walnut.csv");
  verb.work([options](const Cancellation& cancellation) { return fit(*options, cancellation); });
}

}  // namespace ramify::cli
