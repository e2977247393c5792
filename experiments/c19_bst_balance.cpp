// C19, Theorem C.2 (Kruszewski 1996): the balance number of a random binary search tree satisfies P{B_n >=
// (1+eps) log_3 n} -> 0. False as printed: B_n / log n -> min_t t/log(1 + (t-1) 2^t) = 1.0262..., above 1/log
// 3 = 0.9102 (docs/theory/balance.md). The text of the proof breaks off after "Markov's inequality gives us";
// its first moment, optimised, gives the larger constant.
//
// E B_n exceeds log_3 n by 0.42 at n = 1000 and by ever more. The sizes at which the median goes up, to
// 10^30, leave nothing near 0.9102.
#include <cmath>

#include "growth.hpp"

#include "ramify/theory/balance_constant.hpp"

namespace ramify {
namespace {

constexpr const char* convention_of_balance = "most edges to a smaller-or-equal child on a path";

Statement printed_bound(const Model& bst) {
  return {"C19.1",
          "P{B_n >= (1+eps) log_3 n} -> 0, bst",
          "K96 Theorem C.2",
          convention_of_balance,
          Relation::at_most,
          "1/log 3",
          1 / std::log(3.0),
          {{"1/log 4, uniform trees", 1 / std::log(4.0)}},
          NamedValue{"min over t > 1 of t/log(1 + (t-1) 2^t)", balance_constant(bst).value().value}};
}

Statement optimised_bound(const Model& bst) {
  return {"C19.2",
          "B_n ~ 1.0262 log n, bst",
          "Biggins 1978; docs/theory/balance.md",
          convention_of_balance,
          Relation::equals,
          "min over t > 1 of t/log(1 + (t-1) 2^t)",
          balance_constant(bst).value().value,
          {{"1/log 3, Theorem C.2", 1 / std::log(3.0)},
           {"2/log 5, not minimised but at t = 2", 2 / std::log(5.0)}},
          std::nullopt};
}

}  // namespace

Claim bst_balance_claim() {
  const Model bst = Model::parse("bst");
  const StatisticInfo& balance = statistic::balance;
  const auto limit =
      growth_basis({bst, {&balance, GrowthLadder::Rungs::medians, GrowthLadder::Approach::drifts, 1e30}});
  return growth_claim(
      {"C19",
       "B_n <= (1+eps) log_3 n: balance number of random BSTs",
       "K96 Theorem C.2",
       {{printed_bound(bst), bst, &balance, limit}, {optimised_bound(bst), bst, &balance, limit}},
       {}},
      {"C19_bst_balance", "Balance number of random binary search trees", "mean B_n"});
}

}  // namespace ramify
