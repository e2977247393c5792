// C17 (Corollary B.2 with Theorem B.2): the fill level of a random PATRICIA tree grows like S_n: F_n / log n
// -> 1 / log(1/min(p,q)).
//
// F <= S <= B holds in every tree (Lemmas B.3, B.4), so F has the limit of S; it comes from below, with a log
// log n term (Devroye 1992 for p = 1/2), which is why p = 1/2 is the slowest. That term is one of those that
// are fitted. The sandwich itself is c17_sandwich.cpp.
#include <algorithm>
#include <iterator>

#include "patricia.hpp"
#include "sandwich.hpp"

#include "ramify/theory/fill_level_constant.hpp"

namespace ramify {

Claim patricia_fill_claim() {
  const GrowthLaw law{"K96 Corollary B.2", "F_n ~ log(n)/log(1/p)",
                      "deepest full level, root at level 0, external nodes counted", fill_level_constant,
                      rival_patricia_orders};
  auto parts = growth_parts("C17", law, patricia_cases(statistic::fill_level, 1e30));
  std::ranges::move(sandwich_parts(), std::back_inserter(parts));
  return growth_claim({"C17",
                       "F <= S <= B, and F_n/log n -> 1/log(1/min(p,q)): fill level of random PATRICIA trees",
                       law.source,
                       std::move(parts),
                       {}},
                      {"C17_patricia_fill", "Fill level of PATRICIA trees", "mean F_n (levels)"});
}

}  // namespace ramify
