#include <memory>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/memory.hpp"
#include "ramify/draw/drawing_file.hpp"
#include "ramify/draw/node_link.hpp"
#include "ramify/format/read_trees.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/read_count.hpp"
#include "ramify/tree/contract_unary.hpp"

namespace ramify::cli {
namespace {

struct DrawArguments {
  std::string tree, format = "auto", root, which, model, n, seed = "1996", replicate = "0",
                    style = "dendrogram", leaf_order = "1", output;
  bool same_lengths = false, keep_unary = false;
};

/// One of several trees must be named: which of them is drawn is never a guess.
RecordedTree chosen(std::vector<RecordedTree> trees, const DrawArguments& options) {
  if (options.which.empty() && trees.size() > 1)
    throw Error(fmt::format("{} holds {} trees", options.tree, trees.size()), "a drawing shows one",
                fmt::format("add --which K, K from 1 to {}", trees.size()));
  const std::uint64_t which = options.which.empty() ? 1 : read_count("--which", options.which);
  if (which < 1 || which > trees.size())
    throw Error(fmt::format("--which {}", which),
                fmt::format("{} holds {} trees", options.tree, trees.size()),
                fmt::format("take a number from 1 to {}", trees.size()));
  return std::move(trees[which - 1]);
}

RecordedTree read_tree(const DrawArguments& options) {
  Remarks remarks;
  auto trees = read_trees(read_tree_file(options.tree), options.tree, parse_tree_format(options.format),
                          {options.root}, remarks);
  for (const auto& line : remarks.lines(options.tree)) fmt::print(stderr, "ramify: warning: {}\n", line);
  RecordedTree tree = chosen(std::move(trees), options);
  return options.keep_unary ? tree : contract_unary(std::move(tree));
}

/// Of a tree, its layout and the lines of its picture: what was measured and a tenth; and of the page.
double drawing_bytes(double nodes) {
  return 6e7 + 110 * nodes;
}

RecordedTree grow_tree(const DrawArguments& options, const DrawingFile& file,
                       const Cancellation& cancellation) {
  const Model model = Model::parse(options.model);
  const Size n = read_count("--n", options.n);
  model.require_size(n);
  const auto nodes = [&model](Size size) {
    return model.is_split() ? 2 * static_cast<double>(size) + 1 : model.grown().expected_nodes(size);
  };
  file.require_room(nodes(n));
  require_memory("the drawing", "--n", n, [&](Size size) { return drawing_bytes(nodes(size)); });
  const std::uint64_t replicate = read_count("--replicate", options.replicate);
  const TreeBatch batch{model, n, read_count("--seed", options.seed), 1, false};
  return std::move(batch.grown(replicate, replicate + 1, cancellation).front());
}

RecordedTree tree_to_draw(const DrawArguments& options, const DrawingFile& file,
                          const Cancellation& cancellation) {
  const bool is_model = !options.model.empty();
  if (is_model == !options.tree.empty())
    throw Error(is_model ? "--tree and --model" : "neither --tree nor --model", "a drawing shows one tree",
                "name a file with --tree, or grow one with --model and --n");
  if (!is_model) return read_tree(options);
  if (options.n.empty())
    throw Error(fmt::format("--model {} without --n", options.model), "a tree has a size",
                "add --n, say --n 100");
  return grow_tree(options, file, cancellation);
}

ExitCode draw(const DrawArguments& options, const Cancellation& cancellation) {
  const DrawingFile file(options.output);
  const std::uint64_t leaf_order = read_count("--leaf-order", options.leaf_order);
  if (leaf_order > 1)
    throw Error(fmt::format("--leaf-order {}", leaf_order), "it is 0 or 1", "take one of these");
  const NodeLinkStyle style{parse_form(options.style), static_cast<unsigned>(leaf_order),
                            options.same_lengths};
  const RecordedTree tree = tree_to_draw(options, file, cancellation);
  file.require_room(static_cast<double>(tree.tree.node_count()));
  file.write(node_link_diagram(tree, style), cancellation);
  return ExitCode::done;
}

}  // namespace

void add_draw(Program& program) {
  auto options = std::make_shared<DrawArguments>();
  Verb verb = program.verb("draw", "Draw a tree as a node-link diagram, coloured by Horton-Strahler order");
  verb.option("--tree", options->tree, "file with a tree; - is standard input");
  verb.option("--format", options->format, "of the file, as of measure; auto: found by content",
              Need::defaulted);
  verb.option("--root", options->root, "of a table, as of measure: the id of the root, all or neurites");
  verb.option("--which", options->which,
              "of a file with several trees: the place of the one to draw, from 1");
  verb.flag("--keep-unary", options->keep_unary, "keep one-child nodes instead of contracting them");
  verb.option("--model", options->model, "or grow a tree of this model; see: ramify list models");
  verb.option("--n", options->n, "its size");
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  verb.option("--replicate", options->replicate, "the tree that sample --no-graft prints under this number",
              Need::defaulted);
  verb.option("--style", options->style,
              "dendrogram (root at the left, right angles) or upright (root at the bottom)", Need::defaulted);
  verb.option("--leaf-order", options->leaf_order, "order of the tips in the key: 0 or 1", Need::defaulted);
  verb.flag("--same-lengths", options->same_lengths,
            "every branch as long as another, whatever the file says");
  verb.option("-o,--output", options->output, "the drawing, FILE.svg or FILE.png, written in one step",
              Need::required);
  verb.example("Example: ramify draw --model bst --n 200 -o bst.svg");
  verb.work([options](const Cancellation& cancellation) { return draw(*options, cancellation); });
}

}  // namespace ramify::cli
