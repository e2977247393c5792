// C3 (Kruszewski 1996, 3.1.1): the extremes. A chain has order 1; a complete tree of k levels, external nodes
// among them, and so of 2^k - 1 nodes in all, has order k-1. Counting internal levels alone it would be k.
#include "claim.hpp"
#include "exact_range.hpp"
#include "one_way_trees.hpp"
#include <fmt/format.h>

namespace ramify {
namespace {

Basis chain_orders(const Cancellation& cancellation) {
  constexpr Size largest = 4096;
  const auto orders = one_way_orders(Model::parse("chain"), largest, cancellation);
  ExactRange seen;
  for (Size n = 1; n <= largest; ++n) seen.add(orders[n]);
  return seen.basis(largest, fmt::format("the chain of every n to {}", largest));
}

/// S - (k-1) of the trees that are perfect.
Basis perfect_orders(const Cancellation& cancellation) {
  constexpr std::size_t most_levels = 17;
  constexpr Size largest = (Size{1} << (most_levels - 1)) - 1;
  const auto orders = one_way_orders(Model::parse("complete"), largest, cancellation);
  ExactRange excess;
  for (std::size_t levels = 1; levels <= most_levels; ++levels) {
    const Size internal = (Size{1} << (levels - 1)) - 1;
    excess.add(static_cast<double>(orders[internal]) - static_cast<double>(levels - 1));
  }
  return excess.basis(largest, fmt::format("the perfect tree of every k to {}", most_levels));
}

}  // namespace

Claim extreme_orders_claim() {
  const Statement chain{"C3.1",
                        "S = 1, chain",
                        "K96 3.1.1",
                        "order of the root, leaf order 0",
                        Relation::equals,
                        "1",
                        1,
                        {{"0, leaf order 0 kept", 0}, {"2, leaf order 1", 2}},
                        std::nullopt};
  const Statement perfect{"C3.2",
                          "S = k-1: excess 0, complete of 2^k - 1 nodes",
                          "K96 3.1.1",
                          "k levels of nodes, external ones included; leaf order 0",
                          Relation::equals,
                          "0",
                          0,
                          {{"1, k levels of internal nodes", 1}},
                          std::nullopt};
  return {"C3",
          "the chain has order 1, the complete tree of k levels k-1",
          "K96 3.1.1",
          {part_without_trees(chain, [](const Evidence& e) { return chain_orders(e.cancellation); }),
           part_without_trees(perfect, [](const Evidence& e) { return perfect_orders(e.cancellation); })},
          {}};
}

}  // namespace ramify
