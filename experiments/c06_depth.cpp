// C6, Theorem 2.1 (Kruszewski 1996; Devroye 1998): the depth D_n of the last node of a random split tree
// satisfies D_n / log n -> 1/mu in probability and in mean, mu = E{X log(1/X) + (1-X) log(1/(1-X))}.
//
// Estimator: the slope of the sampled mean of D_n on log n. D_n/log n itself is off by constant/log n (5 %
// for BSTs at n = 4096) and is never judged.
#include "growth.hpp"

#include "ramify/theory/depth_constant.hpp"

namespace ramify {

Claim depth_claim() {
  return growth_law_claim(
      {"C6",
       "D_n/log n -> 1/mu: depth of the last node of a random split tree",
       "K96 Theorem 2.1; DK95 Theorem 1",
       {&statistic::depth, growth_sizes, "split trees whose constant 1/mu is known", has<depth_constant>},
       {},
       {}},
      {"K96 Theorem 2.1", "E D_n ~ log(n)/mu", "nodes on the path to the last node, root counted",
       depth_constant, 0.05, Approach::settles, ""},
      {"C6_depth", "Depth of the last node", "mean D_n (nodes)"});
}

}  // namespace ramify
