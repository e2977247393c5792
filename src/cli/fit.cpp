#include <algorithm>
#include <array>
#include <memory>

#include "reading.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/family/observed_bi_orders.hpp"
#include "ramify/fit/fit_table.hpp"
#include "ramify/fit/model_fit_table.hpp"
#include "ramify/fit/model_fits.hpp"
#include "ramify/fit/ratio_fitter.hpp"
#include "ramify/fit/valley_table.hpp"
#include "ramify/format/binary_trees.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct FitArguments {
  std::vector<std::string> files;
  std::string model, observable = "auto", n, seed = "1996", bootstrap = "0", threads, format = "auto", root,
                     resolve, curve, plot;
  bool pooled = false, robust = false;
  Output output;
};

/// What a file is fitted by.
enum class Observable { ratio, orders, tree };

constexpr std::array<std::string_view, 3> observable_names{"ratio", "orders", "tree"};

/// What a file holds.
Observable content_of(const std::string& text) {
  if (is_bi_order_table(text)) return Observable::tree;
  if (is_order_table(text)) return Observable::orders;
  return is_ratio_table(text) ? Observable::ratio : Observable::tree;
}

Observable observable_of(const FitArguments& options, const std::string& text) {
  const auto named = std::ranges::find(observable_names, options.observable);
  if (named == observable_names.end()) return content_of(text);
  return static_cast<Observable>(named - observable_names.begin());
}

/// The one observable of all files: tables of ratios have other columns, and likelihoods of trees and of
/// counts are not compared.
Observable observable_of(const FitArguments& options, const std::vector<std::string>& texts) {
  const Observable first = observable_of(options, texts.front());
  for (std::size_t i = 1; i < texts.size(); ++i) {
    const Observable other = observable_of(options, texts[i]);
    if (other != first)
      throw Error(fmt::format("{} is fitted by its {}, {} by its {}", options.files[0],
                              observable_names[static_cast<std::size_t>(first)], options.files[i],
                              observable_names[static_cast<std::size_t>(other)]),
                  "a table holds fits of one kind", "fit them one by one, or name one with --observable");
  }
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
  if (options.observable != "auto" &&
      std::ranges::find(observable_names, options.observable) == observable_names.end())
    throw Error(fmt::format("--observable {}", options.observable), "not an observable that fit knows",
                "take ratio, orders, tree, or auto");
  if (options.format != "auto" && options.format != "table" && options.format != "csv")
    throw Error(fmt::format("--format {}", options.format), "not a format that fit writes",
                "take table, csv, or auto");
}

bool is_for_reading(const FitArguments& options) {
  return options.format == "table" || (options.format == "auto" && options.output.is_for_reading());
}

/// The options that are of counts alone.
void require_counts_for(const FitArguments& options, Observable observable) {
  if (observable == Observable::orders) return;
  const auto refuse = [observable](const std::string& option, const char* why) {
    throw Error(fmt::format("{} of a {}", option, observable_names[static_cast<std::size_t>(observable)]),
                why, "leave it out, or fit counts of streams with --observable orders");
  };
  if (options.robust) refuse("--robust", "it is for an odd order among counts");
  if (!options.curve.empty()) refuse("--curve", "it is of shapes that counts cannot tell apart");
  if (!options.plot.empty()) refuse("--plot", "it draws shapes that counts cannot tell apart");
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

ModelFitOptions model_options(const FitArguments& options, const Workforce& workforce) {
  if (!options.n.empty())
    throw Error(fmt::format("--n {}", options.n),
                "a tree, or a table of counts, says its n itself: tips less one",
                "leave it out, or fit the ratio with --observable ratio");
  ModelFitOptions fit;
  fit.families = chosen_families(options.model.empty() ? "all" : options.model, all_families());
  fit.bootstrap_trees = read_bootstrap(options.bootstrap);
  fit.seed = read_count("--seed", options.seed);
  fit.workforce = workforce;
  fit.density = options.robust ? CountDensity::huber : CountDensity::gaussian;
  fit.valleys = !options.curve.empty() || !options.plot.empty();
  if (fit.valleys && std::ranges::none_of(fit.families, [](const Family* family) {
        return family->mirror == Mirror::exchanged;
      }))
    throw Error("--curve, --plot", "none of these families has two shapes a and b",
                "add beta or beta_multinomial to --model");
  fit.progress = progress_line("fit");
  return fit;
}

/// The trees of a file, binary unless no family is.
std::vector<RecordedTree> trees_of(const FitArguments& options, const std::string& text,
                                   const std::string& file, const ModelFitOptions& how) {
  Remarks remarks;
  auto trees = read_trees(text, file, std::nullopt, {options.root, 0}, remarks);
  for (const auto& line : remarks.lines(file)) fmt::print(stderr, "ramify: warning: {}\n", line);
  if (std::ranges::none_of(how.families, [](const Family* family) { return family->model->is_binary; }))
    return trees;
  return binary_trees(
      std::move(trees), file,
      {options.resolve, read_count("--seed", options.seed), "trees of all families are binary"});
}

/// A table of the orders that meet: the families given the order, if none is named.
std::vector<FittedDatum> fit_bi_orders_of(const FitArguments& options, Observable observable,
                                          const std::string& text, const std::string& file,
                                          ModelFitOptions how, const Cancellation& cancellation) {
  if (observable != Observable::tree)
    throw Error(fmt::format("--observable {} of {}", options.observable, file),
                "it holds the orders that meet, which say more than counts", "leave --observable out");
  if (options.model.empty()) {
    how.families.clear();
    for (const Family& family : all_families())
      if (family.given == Given::order) how.families.push_back(&family);
  }
  return fit_bi_order_table(ObservedBiOrders::of_table(CsvData::parse(text, file)), file, how, cancellation);
}

std::vector<FittedDatum> fit_file(const FitArguments& options, Observable observable, const std::string& text,
                                  const std::string& file, const ModelFitOptions& how,
                                  const Cancellation& cancellation) {
  if (is_bi_order_table(text)) return fit_bi_orders_of(options, observable, text, file, how, cancellation);
  if (observable == Observable::tree)
    return fit_whole_trees(trees_of(options, text, file, how), file, options.pooled, how, cancellation);
  if (content_of(text) == Observable::tree)
    return fit_order_counts(order_counts_of(trees_of(options, text, file, how)), file, how, cancellation);
  const auto tables = read_order_counts(SourceText(text, file));
  for (const auto& table : tables)
    for (const auto& warning : table.warnings) fmt::print(stderr, "ramify: warning: {}\n", warning);
  return fit_order_counts(tables, file, how, cancellation);
}

ExitCode fit_models(const FitArguments& options, Observable observable, const std::vector<std::string>& texts,
                    const Workforce& workforce, const Cancellation& cancellation) {
  const ModelFitOptions how = model_options(options, workforce);
  const auto picture = picture_file(options.plot);
  std::vector<FittedDatum> data;
  for (std::size_t i = 0; i < texts.size(); ++i)
    for (auto& datum : fit_file(options, observable, texts[i], options.files[i], how, cancellation))
      data.push_back(std::move(datum));
  if (!workforce.leads()) return ExitCode::done;
  if (picture) picture->draw(valley_plot(data));
  if (!options.curve.empty()) emit(write_csv(valley_table(data)), {options.curve});
  emit(is_for_reading(options) ? model_fit_text(data) : write_csv(model_fit_table(data)), options.output);
  return any_not_converged(data) ? ExitCode::no_convergence : ExitCode::done;
}

/// Of a job of several processes: trees of a bootstrap are all that they share.
bool is_for_all(const FitArguments& options, Team* team) {
  if (team == nullptr || options.bootstrap != "0") return true;
  if (team->leads()) say_alone("fit without --bootstrap", *team);
  return team->leads();
}

ExitCode fit(const FitArguments& options, Team* team, const Cancellation& cancellation) {
  if (!is_for_all(options, team)) return ExitCode::done;
  require_known(options);
  std::vector<std::string> texts;
  for (const auto& file : options.files) texts.push_back(read_tree_file(file));
  const Observable observable = observable_of(options, texts);
  require_counts_for(options, observable);
  return observable == Observable::ratio
             ? fit_ratios(options, texts, cancellation)
             : fit_models(options, observable, texts, read_workforce(options.threads, team), cancellation);
}

}  // namespace

void add_fit(Program& program) {
  auto options = std::make_shared<FitArguments>();
  Verb verb =
      program.verb("fit", "Fit models to measured trees: to counts of streams, or to a bifurcation ratio");
  verb.option("data", options->files,
              "trees as measure reads them, CSV of stream counts (order,count), of the orders that meet "
              "(order,side,count) or of ratios (name,ratio,branches)",
              Need::required);
  verb.option("--model", options->model,
              "families to fit, NAME[,NAME..] or all; see: ramify list families. Of a ratio patricia or dst");
  verb.option(
      "--observable", options->observable,
      "what is fitted: tree (its splits), orders (its counts of streams), ratio; auto: what the file holds",
      Need::defaulted);
  verb.option("--bootstrap", options->bootstrap,
              "trees of every fitted model that are fitted again: intervals, bias, goodness, and whether a "
              "simpler family suffices",
              Need::defaulted);
  verb.flag("--robust", options->robust,
            "Huber's loss: one odd order of a table of counts does not decide alone");
  verb.option("--curve", options->curve,
              "write the pairs (a,b) that fit counts nearly as well into this file, as CSV");
  verb.option("--plot", options->plot, "draw these pairs into this file, FILE.svg or FILE.png");
  verb.flag("--pooled", options->pooled, "one fit of all trees of a file, and not one of each");
  verb.option("--root", options->root, "of a table with trees: the id of the root, all, or neurites");
  add_resolve(verb, options->resolve);
  verb.option("--n", options->n, "internal nodes, in place of the size in a table of ratios");
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  add_threads(verb, options->threads);
  verb.option("--format", options->format,
              "table (aligned, with notes) or csv; auto: table on a terminal, else csv", Need::defaulted);
  options->output.add_table_to(verb);
  verb.example("Example: ramify fit data/walnut.csv");
  verb.team_work(
      [options](Team* team, const Cancellation& cancellation) { return fit(*options, team, cancellation); });
}

}  // namespace ramify::cli
