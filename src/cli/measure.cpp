#include <memory>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/measure/measure_json.hpp"
#include "ramify/measure/measure_tables.hpp"
#include "ramify/text/read_count.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace ramify::cli {
namespace {

const std::vector<std::string> outputs{"orders", "summary", "levels", "nodes", "json"};

struct Options {
  std::vector<std::string> files;
  std::string format = "auto", leaf_order = "1", root, scale = "0", output = "orders", out;
  bool keep_unary = false;
};

/// What the files hold, as far as the output asks for it.
struct Measured {
  std::vector<MeasuredOrders> orders;
  std::vector<TreeMeasurement> all;
  Table levels = level_table(), nodes = node_table();
};

unsigned small_number(const std::string& option, const std::string& text, std::uint64_t most) {
  const std::uint64_t value = read_count(option, text);
  if (value > most)
    throw Error(fmt::format("{} {}", option, text), fmt::format("it is from 0 to {}", most),
                "take one of these");
  return static_cast<unsigned>(value);
}

void measure_counts(const std::string& text, const std::string& file, const Options& options,
                    Measured& measured) {
  const OrderCounts counts = read_order_counts(CsvData::parse(text, file));
  for (const auto& warning : counts.warnings) fmt::print(stderr, "ramify: warning: {}\n", warning);
  if (options.output == "nodes" || options.output == "levels")
    throw Error(fmt::format("{}: --output {}", file, options.output), "a table of counts has no nodes",
                "take orders, summary or json");
  MeasuredOrders orders = measure_orders(counts, file);
  if (options.output == "orders") {
    measured.orders.push_back(std::move(orders));
  } else {
    measured.all.push_back({std::move(orders), std::nullopt, {}});
  }
}

void measure_one(const RecordedTree& tree, unsigned leaf_order, const Options& options, Measured& measured) {
  if (options.output == "orders") {
    measured.orders.push_back(measure_orders(tree));
  } else if (options.output == "levels") {
    add_levels(measured.levels, tree);
  } else if (options.output == "nodes") {
    add_nodes(measured.nodes, tree, leaf_order);
  } else {
    measured.all.push_back(measure_all(tree));
  }
}

std::string text_of(const Measured& measured, unsigned leaf_order, const std::string& output) {
  if (output == "json") return measurement_json(measured.all, leaf_order);
  if (output == "orders") return write_csv(orders_table(measured.orders, leaf_order));
  if (output == "summary") return write_csv(summary_table(measured.all, leaf_order));
  return write_csv(output == "levels" ? measured.levels : measured.nodes);
}

ExitCode measure(const Options& options, const Cancellation& cancellation) {
  if (std::ranges::find(outputs, options.output) == outputs.end())
    throw Error(fmt::format("--output {}", options.output), "no such table",
                fmt::format("{}take {}", did_you_mean(options.output, outputs), fmt::join(outputs, ", ")));
  const auto format = parse_tree_format(options.format);
  const unsigned leaf_order = small_number("--leaf-order", options.leaf_order, 1);
  const ReadOptions reading{options.root, small_number("--scale", options.scale, 1000)};
  Measured measured;
  for (const auto& file : options.files) {
    const std::string text = read_tree_file(file);
    if (!format && is_order_table(text)) {
      measure_counts(text, file, options, measured);
      continue;
    }
    for (RecordedTree& tree : read_trees(text, file, format, reading)) {
      if (cancellation.requested()) throw Interrupted();
      if (!options.keep_unary) tree = contract_unary(std::move(tree));
      measure_one(tree, leaf_order, options, measured);
    }
  }
  emit(text_of(measured, leaf_order, options.output), options.out);
  return ExitCode::done;
}

}  // namespace

void add_measure(Program& program) {
  auto options = std::make_shared<Options>();
  Verb verb = program.verb("measure", "Orders, ratios and every statistic of trees read from files");
  verb.option("FILE", options->files, "files of trees, or of counts of streams; - is standard input",
              Need::required);
  verb.option("--format", options->format,
              "newick, swc, mtg, qsm, edges, flowlines, parens or json; auto: found by content",
              Need::defaulted);
  verb.option("--leaf-order", options->leaf_order, "order of the tips in the table: 0 or 1", Need::defaulted);
  verb.option("--root", options->root,
              "of a table: the id of the root; all: every root a tree of its own; neurites: what leaves "
              "the soma of a neuron");
  verb.option("--scale", options->scale, "of an MTG: the scale of the nodes; 0 the finest", Need::defaulted);
  verb.flag("--keep-unary", options->keep_unary,
            "count one-child nodes, as in tries, instead of contracting them");
  verb.option("--output", options->output,
              "orders, summary (a row a tree), levels (a row a depth), nodes (a row a node) or json",
              Need::defaulted);
  verb.option("-o,--out", options->out, "write the table to this file, in one step");
  verb.example("Example: ramify measure data/examples/sapling.newick");
  verb.work([options](const Cancellation& cancellation) { return measure(*options, cancellation); });
}

}  // namespace ramify::cli
