#include <algorithm>
#include <atomic>
#include <cstdio>
#include <memory>
#include <thread>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/core/number.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/sample/graft_rule.hpp"
#include "ramify/tabulate/sample_plot.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct SampleArguments {
  std::string preset, model, n, seed = "1996", replicates = "1", replicate, statistics = "strahler,height",
                                format = "csv", threads, plot;
  Output output;
  bool no_graft = false, yes = false;
};

/// The replicates asked for: 0..count-1, or one alone.
struct Range {
  std::uint64_t first, last;
};

Range read_range(const SampleArguments& options) {
  if (!options.replicate.empty()) {
    const std::uint64_t one = read_count("--replicate", options.replicate);
    return {one, one + 1};
  }
  const std::uint64_t count = read_count("--replicates", options.replicates);
  if (count == 0) throw Error("--replicates 0", "there would be no tree", "ask for one or more");
  return {0, count};
}

struct SizedModel {
  Model model;
  Size n;
};

/// Of --preset, whose size --n may replace, or of --model and --n.
SizedModel read_model(const SampleArguments& options) {
  if (options.preset.empty()) {
    if (options.model.empty() || options.n.empty())
      throw Error("neither --preset nor --model and --n", "sample must know what to grow",
                  "write, say, --model bst --n 100; see: ramify list models, ramify list presets");
    return {Model::parse(options.model), read_count("--n", options.n)};
  }
  const Preset& preset = find_preset(options.preset);
  if (!options.model.empty())
    throw Error(fmt::format("--preset {} and --model {}", options.preset, options.model),
                "a preset has a model of its own", "leave one of them out");
  return {Model::parse(preset.model), options.n.empty() ? preset.n : read_count("--n", options.n)};
}

TreeFormat tree_format(const std::string& name) {
  std::vector<std::string> names{"csv"};
  for (const TreeFormat format : written_formats()) {
    if (name == name_of(format)) return format;
    names.emplace_back(name_of(format));
  }
  throw Error(fmt::format("--format {}", name), "not a format that sample writes",
              fmt::format("{}take csv (statistics) or one of the trees: {}", did_you_mean(name, names),
                          fmt::join(names.begin() + 1, names.end(), ", ")));
}

ExitCode sample(const SampleArguments& options, const Cancellation& cancellation) {
  const auto [model, n] = read_model(options);
  model.require_size(n);
  const Range range = read_range(options);
  const TreeBatch batch{model,
                        n,
                        read_count("--seed", options.seed),
                        read_threads(options.threads),
                        !options.no_graft,
                        progress_line("sample")};
  const auto picture = picture_file(options.plot);
  const double trees = static_cast<double>(range.last - range.first);
  if (options.format == "csv") {
    const auto statistics = StatisticSet::parse(split_list(options.statistics));
    require_consent(trees * GraftRule(model, sampling_method(statistics, batch.graft)).grown_nodes(n),
                    options.yes);
    if (picture) require_histogram(statistics);
    batch.require_memory(statistics, range.last - range.first);
    const Table table = batch.table(statistics, range.first, range.last, cancellation);
    if (picture) picture->draw(sample_plot(batch, *statistics.chosen().front(), table));
    emit(table, options.output);
  } else {
    const TreeFormat format = tree_format(options.format);
    if (picture)
      throw Error(fmt::format("--plot with --format {}", options.format), "a histogram is of a statistic",
                  "leave one of them out; ramify draw shows a tree");
    require_consent(trees * static_cast<double>(n), options.yes);
    batch.require_memory(format, range.last - range.first);
    emit(batch.trees(format, range.first, range.last, cancellation), options.output);
  }
  return ExitCode::done;
}

}  // namespace

void add_sample(Program& program) {
  auto options = std::make_shared<SampleArguments>();
  Verb verb = program.verb("sample", "Grow trees of one model and print their statistics, or the trees");
  verb.option("--model", options->model, "model, such as bst or \"beta(10,80)\"; see: ramify list models");
  verb.option("--n", options->n, "size: internal nodes, 0 to 2^62");
  verb.option("--preset", options->preset,
              "model and size of a figure; --n takes another size. See: ramify list presets");
  const DeclaredOption count =
      verb.option("--replicates", options->replicates, "number of trees", Need::defaulted);
  Verb::exclude(count,
                verb.option("--replicate", options->replicate, "replay this one alone (counted from 0)"));
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  verb.option("--statistics,--statistic", options->statistics, "comma-separated; see: ramify list statistics",
              Need::defaulted);
  verb.option("--format", options->format,
              "csv: a table of statistics; newick, edges, swc, parens, json: the trees", Need::defaulted);
  add_threads(verb, options->threads);
  verb.flag("--no-graft", options->no_graft,
            "grow every node, instead of drawing subtrees from their exact laws where that pays");
  verb.flag("--yes", options->yes, "allow more than 10^13 nodes");
  options->output.add_table_to(verb);
  verb.option("--plot", options->plot,
              "draw the histogram of one statistic into this file, FILE.svg or FILE.png");
  verb.example(
      "Example: ramify sample --model \"patricia(1/4.35)\" --n 579 --replicates 3 --statistics "
      "strahler,streams");
  verb.work([options](const Cancellation& cancellation) { return sample(*options, cancellation); });
}

}  // namespace ramify::cli
