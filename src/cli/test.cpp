#include <memory>

#include "session.hpp"
#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/experiment/tree_comparison.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/io/read_count.hpp"
#include "ramify/text/text_file.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify::cli {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string model, seed = "1996", replicates = "1999", threads, output;
};

struct NamedTree {
  std::string name;
  Tree tree;
};

/// One tree a line; named by the file, and by the line where there are several.
std::vector<NamedTree> read_trees(const std::string& file) {
  const std::string text = read_text_file(file);
  std::vector<NamedTree> trees;
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view word = trimmed(std::string_view(text).substr(begin, end - begin));
    const std::string name = fmt::format("{}:{}", file, ++line);
    if (!word.empty()) trees.push_back({name, from_parentheses(word, name)});
    begin = end + 1;
  }
  if (trees.empty())
    throw Error(fmt::format("{}: no tree", file), "a tree is a line of E and (LR)",
                "write one, such as ((EE)E); ramify sample --format parens prints them");
  if (trees.size() == 1) trees.front().name = file;
  return trees;
}

ExitCode test(const Options& options, const Cancellation& cancellation) {
  const Model model = Model::parse(options.model);
  const Simulation simulation{read_count("--seed", options.seed),
                              read_count("--replicates", options.replicates), read_threads(options.threads)};
  if (simulation.trees < 99)
    throw Error(fmt::format("--replicates {}", simulation.trees),
                "the smallest p-value is 2/(replicates + 1): with fewer than 99 trees above 0.02",
                "take 99 or more");
  CsvTable table({"tree", "model", "statistic", "observed", "expected", "p_value", "effect", "adjusted_p",
                  "standard_error", "method"});
  TreeComparison compare(model, simulation, cancellation);
  for (const auto& file : options.files)
    for (const auto& [name, tree] : read_trees(file))
      for (const auto& row : compare(tree, name))
        table.add({name, model.text(), row.name, format_summary(row.observed), format_summary(row.expected),
                   format_summary(row.p_value), format_summary(row.effect()), format_summary(row.adjusted_p),
                   format_summary(row.deviation),
                   row.exact ? "exact law" : fmt::format("{} trees", simulation.trees)});
  emit(table.text(), options.output);
  return ExitCode::done;
}

}  // namespace

void add_test(CLI::App& app, Session& session) {
  auto options = std::make_shared<Options>();
  auto* verb = app.add_subcommand(
      "test", "Is a tree like trees of a model? Its statistics beside theirs, with p-values");
  verb->add_option("TREE", options->files, "files of trees as words of E and (LR), one a line")->required();
  verb->add_option("--model", options->model,
                   "model, such as bst or \"beta(10,80)\"; see: ramify list models")
      ->required();
  verb->add_option("--replicates", options->replicates, "trees to simulate for what has no exact law")
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "seed")->capture_default_str();
  verb->add_option("--threads", options->threads,
                   "threads; all cores if left out. The result does not depend on it");
  verb->add_option("-o,--output", options->output, "write the table to this file, in one step");
  verb->footer("Example: ramify test my_tree.txt --model bst");
  verb->callback([&session, options] {
    session.work = [&session, options] { return test(*options, session.cancellation); };
  });
}

}  // namespace ramify::cli
