// C13 (Fact 3.4) and C17 (Theorem B.3): the Horton-Strahler number of a random PATRICIA tree satisfies
// S_n / log n -> 1 / log(1/min(p,q)) in probability.
//
// S_n is nearly deterministic and goes up by one about every factor 1/p in n, and n_k p^k, n_k where P(S >=
// k) = 1/2, drifts: no theory says how, so powers of k^(-1/2) are fitted beside log k. For p = 1/2 the steps
// are sharper than the grid of the laws from n = 10^20 on; there F_n <= S_n <= log2(n+1) (Lemma B.4; C2)
// leaves less than S_n itself would.
#include <cmath>

#include "patricia.hpp"

#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

/// Between the limit of the fill level and 1/log 2.
Basis between_bounds(const Basis& fill_level) {
  Basis basis = fill_level;
  basis.interval.upper = 1 / std::log(2.0);
  basis.estimate = std::min(basis.estimate, basis.interval.upper);
  basis.method = "S_n <= log2(n+1) in every tree; from below F_n <= S_n, " + basis.method;
  return basis;
}

std::vector<ClaimPart> patricia_order_parts(const GrowthLaw& law) {
  constexpr double largest_even = 1e30;
  auto parts = growth_parts("C13", law, patricia_cases(statistic::strahler, largest_even));
  const GrowthCase fill_level = patricia_cases(statistic::fill_level, largest_even).front();
  parts.front().basis = [below = growth_basis(fill_level)](const Evidence& evidence) {
    return between_bounds(below(evidence));
  };
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
