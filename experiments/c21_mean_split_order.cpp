// C21, the counter-example of Kruszewski 1996, 3.2.2: it is not true of every X that E S_n = log_(1/EX) n.
// beta(1,1), the random BST, has EX = 1/2, and its order does not grow like log_2 n. So much is right; the
// log_3 n that the thesis has instead is not (C20).
//
// Nor does it hold of beta(10,10), EX = 1/2 too: mean alone decides nothing, the two have ratios 3.0438 and
// 2.4969.
#include <cmath>

#include "growth.hpp"
#include <fmt/format.h>

#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

/// The statement that the thesis refutes.
ClaimPart order_by_mean(std::string part, const Model& model) {
  const double mean = split_mean(model).value().value;
  const Statement statement{
      std::move(part),
      fmt::format("E S_n ~ log_(1/EX) n, {} (\"not true\")", model.text()),
      "denied by K96 3.2.2",
      "order of the root, leaf order 0",
      Relation::equals,
      "1/log(1/EX)",
      -1 / std::log(mean),
      {},
      NamedValue{"1/log R, R the Horton ratio", strahler_constant(model).value().value}};
  return part_without_trees(statement, growth_basis({model,
                                                     {&statistic::strahler, GrowthLadder::Rungs::medians,
                                                      GrowthLadder::Approach::settles, 1e12}}));
}

}  // namespace

Claim mean_split_order_claim() {
  return {"C21",
          "E S_n = log_(1/EX) n is not true of every X",
          "K96 3.2.2",
          {order_by_mean("C21.1", Model::parse("bst")), order_by_mean("C21.2", Model::parse("beta(10,10)"))},
          {}};
}

}  // namespace ramify
