#include <memory>
#include <utility>

#include "reading.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/compare/tree_comparison.hpp"
#include "ramify/format/binary_trees.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct TestArguments {
  std::vector<std::string> files;
  std::string model, format = "auto", root, resolve, seed = "1996", replicates = "1999", threads;
  Output output;
};

/// The trees of a file, without one-child nodes where those of the model have none.
std::vector<RecordedTree> trees_for(const Model& model, const TestArguments& options,
                                    const std::string& file) {
  Remarks remarks;
  auto trees =
      read_trees(read_tree_file(file), file, parse_tree_format(options.format), {options.root, 0}, remarks);
  for (const auto& line : remarks.lines(file)) fmt::print(stderr, "ramify: warning: {}\n", line);
  if (!model.is_split()) return trees;
  const std::string because = fmt::format("trees of {} are binary", model.text());
  return binary_trees(std::move(trees), file, {options.resolve, read_count("--seed", options.seed), because});
}

std::string method_of(const ComparedStatistic& of, const Simulation& simulation) {
  const std::string method = of.exact ? "exact law" : fmt::format("{} trees", simulation.trees);
  return of.is_bound ? method + ", p_value a bound" : method;
}

/// "< 1e-20", "< 2/2000"
std::string bound_text(const ComparedStatistic& of, const Simulation& simulation) {
  return of.exact ? fmt::format("< {:g}", of.p_value) : fmt::format("< 2/{}", simulation.trees + 1);
}

Row row_of(const ComparedStatistic& of, const std::string& tree, const Model& model,
           const Simulation& simulation, bool for_reading) {
  Row row;
  row.texts({tree, model.text(), of.column.name()});
  if (of.column.statistic->is_order)
    row.whole(0);
  else
    row.nothing();
  row.summary(of.observed).summary(of.expected);
  if (for_reading && of.is_bound)
    row.text(bound_text(of, simulation));
  else
    row.summary(of.p_value);
  return row.summary(of.effect())
      .summary(of.adjusted_p)
      .summary(of.deviation)
      .text(method_of(of, simulation));
}

ExitCode test(const TestArguments& options, const Cancellation& cancellation) {
  const Model model = Model::parse(options.model);
  const Simulation simulation{read_count("--seed", options.seed), read_replicates(options.replicates),
                              read_threads(options.threads)};
  Table table({"tree", "model", "statistic", "leaf_order", "observed", "expected", "p_value", "effect",
               "adjusted_p", "standard_error", "method"});
  TreeComparison compare(model, simulation, cancellation);
  for (const auto& file : options.files)
    for (const RecordedTree& tree : trees_for(model, options, file))
      for (const auto& row : compare(tree.tree, tree.name))
        table.add(row_of(row, tree.name, model, simulation, options.output.is_for_reading()));
  emit(table, options.output);
  return ExitCode::done;
}

}  // namespace

void add_test(Program& program) {
  auto options = std::make_shared<TestArguments>();
  Verb verb =
      program.verb("test", "Is a tree like trees of a model? Its statistics beside theirs, with p-values");
  verb.option("TREE", options->files, "files of trees; - is standard input", Need::required);
  verb.option("--format", options->format,
              "newick, nexus, swc, mtg, qsm, edges, flowlines, parens or json; auto: found by content",
              Need::defaulted);
  verb.option("--root", options->root, "of a table: the id of the root, all, or neurites");
  add_resolve(verb, options->resolve);
  verb.option("--model", options->model, "model, such as bst or \"beta(10,80)\"; see: ramify list models",
              Need::required);
  verb.option("--replicates", options->replicates, "trees to simulate for what has no exact law",
              Need::defaulted);
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  add_threads(verb, options->threads);
  options->output.add_table_to(verb);
  verb.example("Example: ramify test my_tree.txt --model bst");
  verb.work([options](const Cancellation& cancellation) { return test(*options, cancellation); });
}

}  // namespace ramify::cli
