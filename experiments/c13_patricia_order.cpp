// C13 (Fact 3.4) and C17 (Theorem B.3): the Horton-Strahler number of a random PATRICIA tree satisfies
// S_n / log n -> 1 / log(1/min(p,q)) in probability.
//
// S_n is nearly deterministic and goes up by one about every factor 1/p in n, and n_k p^k, n_k where P(S >=
// k) = 1/2, drifts: no theory says how, so powers of k^(-1/2) are fitted beside log k. For p = 1/2 the steps
// are sharper than the grid of the laws from n = 10^20 on; there F_n <= S_n <= log2(n+1) (Lemma B.4; C2)
// leaves less than S_n itself would.
#include "patricia.hpp"

#include "ramify/model/model_info.hpp"
#include "ramify/model/patricia.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

std::optional<Constant> constant_of_patricia(const Model& dst) {
  return strahler_constant(Model::make(Patricia::info(), dst.parameters()));
}

/// Of digital search trees, whose split, Bin(n-1,p), the thesis takes for that of PATRICIA.
ClaimPart dst_order_part() {
  const GrowthLaw law{"K96 3.2.2", "S_n ~ log(n)/log(1/p)", "order of the root, leaf order 0",
                      constant_of_patricia, rival_patricia_orders};
  auto [statement, model, statistic, basis] =
      growth_parts(
          "C13", law,
          {{Model::parse("dst(0.23)"),
            {&statistic::strahler, GrowthLadder::Rungs::medians, GrowthLadder::Approach::drifts, 1e60}}})
          .front();
  statement.part = "C13.5";
  return part_without_trees(std::move(statement), std::move(basis));
}

std::vector<ClaimPart> patricia_order_parts(const GrowthLaw& law) {
  constexpr double largest_even = 1e30;
  auto parts = growth_parts("C13", law, patricia_cases(statistic::strahler, largest_even));
  parts.front().basis = above_fair_fill_level("S", largest_even);
  parts.push_back(dst_order_part());
  return parts;
}

}  // namespace

Claim patricia_order_claim() {
  const GrowthLaw law{"K96 Fact 3.4, Theorem B.3", "S_n ~ log(n)/log(1/p)", "order of the root, leaf order 0",
                      strahler_constant, rival_patricia_orders};
  return growth_claim(
      {"C13",
       "S_n/log n -> 1/log(1/min(p,q)): Horton-Strahler number of random PATRICIA trees",
       law.source,
       patricia_order_parts(law),
       {}},
      {"C13_patricia_order", "Horton-Strahler number of PATRICIA trees", "mean S_n (leaf order 0)"});
}

}  // namespace ramify
