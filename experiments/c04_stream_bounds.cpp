// C4 (Viennot, Eyrolles, Janey and Arques 1989, 2.3): there are twice as many streams of an order as of the
// next at least, since a stream begins where two of the order before end. The perfect tree has no more; the
// thin one, a chain, has as many as it has leaves to one.
//
// Nodes of an order keep no such bound: a chain has n+1 of order 0 and n of order 1.
#include <algorithm>

#include "all_trees.hpp"
#include "claim.hpp"
#include "exact_range.hpp"
#include "one_way_trees.hpp"
#include <fmt/format.h>

#include "ramify/sample/measure_tree.hpp"

namespace ramify {
namespace {

constexpr const char* stream_ratio = "streams of order k-1 by streams of order k, leaf order 0";
constexpr Size all_trees_to = 11;

double ratio_of(std::uint64_t below, std::uint64_t above) {
  return static_cast<double>(below) / static_cast<double>(above);
}

/// The least b_(k-1)/b_k of all trees.
template <HortonStrahler::Counts TreeMeasures::* counts>
Basis least_ratio(const Cancellation& cancellation) {
  double least = HUGE_VAL;
  for (Size n = 1; n <= all_trees_to; ++n)
    for_each_binary_tree(n, cancellation, [&](const Tree& tree) {
      const TreeMeasures measures = measure_tree(tree, {0, 0}, 0, orders_and_height);
      for (std::size_t k = 0; k < measures.strahler; ++k)
        least = std::min(least, ratio_of((measures.*counts)[k], (measures.*counts)[k + 1]));
    });
  ExactRange seen;
  seen.add(least);
  return seen.basis(all_trees_to,
                    fmt::format("the least of all binary trees of 1 to {} nodes", all_trees_to));
}

Basis perfect_ratios() {
  constexpr std::size_t most_levels = 49;
  const Size n = (Size{1} << most_levels) - 1;
  const auto streams = one_way_counts(Model::parse("complete"), n).streams;
  ExactRange ratios;
  for (std::size_t k = 0; k + 1 < streams.size(); ++k) ratios.add(ratio_of(streams[k], streams[k + 1]));
  return ratios.basis(static_cast<double>(n),
                      fmt::format("every order of the perfect tree of order {}", most_levels));
}

/// b_0/b_1 - (n+1).
Basis chain_ratios() {
  constexpr Size largest = 200;
  ExactRange excess;
  for (Size n = 1; n <= largest; ++n) {
    const auto streams = one_way_counts(Model::parse("chain"), n).streams;
    excess.add(ratio_of(streams.at(0), streams.at(1)) - static_cast<double>(n + 1));
  }
  return excess.basis(largest, fmt::format("the chain of every n to {}", largest));
}

Statement at_least_twice(std::string part, const std::string& counted, std::string source,
                         std::string convention, std::vector<NamedValue> rivals) {
  return {std::move(part),
          "the least b_(k-1)/b_k is 2 or more, " + counted,
          std::move(source),
          std::move(convention),
          Relation::at_least,
          "2",
          2,
          std::move(rivals),
          std::nullopt};
}

}  // namespace

Claim stream_bounds_claim() {
  const Statement perfect{"C4.3",
                          "b_(k-1)/b_k = 2, complete of 2^k - 1 nodes",
                          "V89 2.3",
                          stream_ratio,
                          Relation::equals,
                          "2",
                          2,
                          {{"3, terminal growth", 3}, {"4, uniform trees", 4}},
                          std::nullopt};
  const Statement chain{
      "C4.4", "b_0/b_1 = n+1: excess 0, chain",   "V89 2.3",   stream_ratio, Relation::equals, "0",
      0,      {{"-1, internal edges alone", -1}}, std::nullopt};
  return {"C4",
          "there are twice as many streams of an order as of the next, at least",
          "V89 2.3",
          {part_without_trees(
               at_least_twice("C4.1", "streams of all binary trees", "V89 2.3", stream_ratio,
                              {{"3, terminal growth", 3}, {"4, uniform trees", 4}}),
               [](const Evidence& e) { return least_ratio<&TreeMeasures::streams>(e.cancellation); }),
           part_without_trees(
               at_least_twice("C4.2", "nodes of all binary trees", "V89 2.3 of the counts of K96 3.1.2",
                              "nodes of order k-1 by nodes of order k, leaf order 0", {}),
               [](const Evidence& e) { return least_ratio<&TreeMeasures::nodes>(e.cancellation); }),
           part_without_trees(perfect, [](const Evidence&) { return perfect_ratios(); }),
           part_without_trees(chain, [](const Evidence&) { return chain_ratios(); })},
          {}};
}

}  // namespace ramify
