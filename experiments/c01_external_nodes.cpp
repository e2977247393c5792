// C1, Fact 2.1 (Kruszewski 1996): a binary tree with n internal nodes has n+1 external ones.
//
// By induction on the root's subtrees. What is looked at is whether the trees here are such trees: all of
// them that there are, counted off their words; and those that every split model grows, where externals and
// internals are counted apart.
#include <algorithm>
#include <array>
#include <numeric>

#include "all_trees.hpp"
#include "claim.hpp"
#include "exact_range.hpp"
#include <fmt/format.h>

#include "ramify/model/registry.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

Statement one_more(std::string part, const std::string& of) {
  return {std::move(part),
          "external nodes - internal nodes = 1, " + of,
          "K96 Fact 2.1",
          "internal nodes have two children",
          Relation::equals,
          "1",
          1,
          {{"0, as many", 0}, {"2, n+2 external nodes", 2}},
          std::nullopt};
}

Basis surplus_in_all_trees(const Cancellation& cancellation) {
  constexpr Size largest = 11;
  ExactRange surplus;
  for (Size n = 1; n <= largest; ++n)
    for_each_binary_tree(n, cancellation, [&](const Tree& tree) {
      const auto external = static_cast<double>(std::ranges::count(tree.arities(), 0u));
      surplus.add(2 * external - static_cast<double>(tree.node_count()));
    });
  return surplus.basis(largest, fmt::format("every binary tree of 1 to {} internal nodes", largest));
}

/// One of each; its parameters do not matter.
constexpr std::array split_models{"bst",        "beta(0.3,3)", "beta_multinomial(2,5)",
                                  "split(0.3)", "dst(0.23)",   "patricia(0.7)",
                                  "catalan",    "aldous(-1)",  "ford(0.3)",
                                  "complete",   "chain"};

/// Throws Error where the registry has a split model that is not among them; one read from a file is none.
void require_all_split_models() {
  for (const ModelInfo& info : models()) {
    const bool is_known =
        !info.is_split || std::holds_alternative<FromFile>(info.make) ||
        std::ranges::any_of(split_models, [&](const char* text) { return Model::parse(text).is(info); });
    if (!is_known)
      throw Error(fmt::format("model {} is missing from claim C1", info.name), "it is of every split model",
                  "add one to experiments/c01_external_nodes.cpp");
  }
}

Basis surplus_in_grown_trees(const Cancellation& cancellation) {
  require_all_split_models();
  constexpr Size largest = 100;
  constexpr std::uint64_t seed = 1, trees = 10;
  ExactRange surplus;
  for (const char* text : split_models) {
    const Model model = Model::parse(text);
    const auto sampler = make_tree_sampler({model, whole_trees(orders_and_height), largest, &cancellation});
    TreeMeasures tree;
    for (Size n = 1; n <= largest; ++n)
      for (std::uint64_t replicate = 0; replicate < trees; ++replicate) {
        sampler->sample(n, {seed, model.stream_cell(n)}, replicate, tree);
        const auto internal = std::accumulate(tree.nodes.begin() + 1, tree.nodes.end(), std::uint64_t{0});
        surplus.add(static_cast<double>(tree.nodes[0]) - static_cast<double>(internal));
      }
  }
  Basis basis = surplus.basis(largest, fmt::format("{} trees of every size to {} of each of {} models", trees,
                                                   largest, split_models.size()));
  basis.evidence = EvidenceKind::sampled;
  basis.standing = Standing::seen;
  return basis;
}

}  // namespace

Claim external_nodes_claim() {
  return {"C1",
          "n internal nodes have n+1 external ones",
          "K96 Fact 2.1",
          {part_without_trees(
               one_more("C1.1", "all binary trees"),
               [](const Evidence& evidence) { return surplus_in_all_trees(evidence.cancellation); }),
           part_without_trees(
               one_more("C1.2", "trees that the split models grow"),
               [](const Evidence& evidence) { return surplus_in_grown_trees(evidence.cancellation); })},
          {}};
}

}  // namespace ramify
