// C7, Theorem 2.2 (Kruszewski 1996; Devroye 1998): the height satisfies H_n / log n -> gamma = min_t t /
// (-log M(t)), M(t) = E{X^t + (1-X)^t}.
//
// The height is a pulled front: its median is gamma log n - c log log n + d + O(1/sqrt(log n)), c = 1.5/(-log
// M(t*)) (Reed 2003 for BSTs; the last term Ebert, van Saarloos 2000), so that at n = 10^9 slopes still fall
// short of gamma by 3 to 5 %. Exact laws to 10^100, in which these terms are fitted, give gamma to 5 digits.
#include <cmath>

#include "growth.hpp"

#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/height_constant.hpp"
#include "ramify/theory/log_moment.hpp"

namespace ramify {
namespace {

/// The bound t/(-log M(t)) at t = 2, where it is the height of a trie, and twice the depth.
std::vector<NamedValue> rival_heights(const Model& model) {
  const LogMomentOf<double> log_moment(BetaSplit::of(model).value());
  return {{"2/(-log M(2)), not minimised", -2 / log_moment(2.0)},
          {"2/mu, twice the depth", 2 * depth_constant(model).value().value}};
}

}  // namespace

Claim height_claim() {
  const GrowthLaw law{"K96 Theorem 2.2; DK95 Theorem 2", "H_n ~ gamma log(n)",
                      "nodes on the longest path, root and external node counted", height_constant,
                      rival_heights};
  return growth_claim(
      {"C7",
       "H_n/log n -> gamma: height of a random split tree",
       law.source,
       growth_parts_with_grid(
           "C7", law, {"bst", "beta(10,10)", "beta(10,80)"},
           {&statistic::height, GrowthLadder::Rungs::medians, GrowthLadder::Approach::drifts, 1e100}, 1e50),
       {}},
      {"C7_height", "Height", "mean H_n (nodes)"});
}

}  // namespace ramify
