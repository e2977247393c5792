// C13 (Fact 3.4) and C17 (Theorem B.3): the Horton-Strahler number of a random PATRICIA tree satisfies
// S_n / log n -> 1 / log(1/min(p,q)) in probability.
//
// S_n is nearly deterministic and steps up by one about every factor 1/p in n, so sizes go up in that ratio
// (p = 1/2: its square) and the slope per step would be exactly 1 in the limit. What is left is a slow drift
// of the thresholds n_k (where P(S >= k) = 1/2): n_k p^k is not constant, by some 2 to 7 % of the slope at
// these sizes.
#include "growth.hpp"

#include "ramify/theory/strahler_constant.hpp"

namespace ramify {

Claim patricia_order_claim() {
  return growth_law_claim(
      {"C13",
       "S_n/log n -> 1/log(1/min(p,q)): Horton-Strahler number of random PATRICIA trees",
       "K96 Fact 3.4 and Theorem B.3",
       {&statistic::strahler, growth_sizes, "random PATRICIA trees", is_of<Patricia>},
       {},
       {}},
      {"K96 Fact 3.4, Theorem B.3", "S_n ~ log(n)/log(1/p)", "order of the root, leaf order 0",
       strahler_constant, 0.05, Approach::drifts, "the thresholds n_k p^k still drift at these sizes"},
      {"C13_patricia_order", "Horton-Strahler number of PATRICIA trees", "mean S_n (leaf order 0)"});
}

}  // namespace ramify
