// C6, Theorem 2.1 (Kruszewski 1996; Devroye 1998): the depth D_n of the last node of a random split tree
// satisfies D_n / log n -> 1/mu in probability and in mean, mu = E{X log(1/X) + (1-X) log(1/(1-X))}.
//
// E D_n = log(n)/mu + constant + O(n^-c), so the slope of the exact mean on log n settles: 11 digits at n =
// 10^12, 6 for beta(10,80), where c is small. D_n/log n itself is off by constant/log n (5 % for BSTs at n =
// 4096) and is never judged.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "depth_range.hpp"
#include "growth.hpp"

#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/split_mean.hpp"

namespace ramify {
namespace {

/// The depth with every split at its mean, and with even ones.
std::vector<NamedValue> rival_depths(const Model& model) {
  const double p = split_mean(model).value().value;
  const double entropy = -p * std::log(p) - (1 - p) * std::log1p(-p);
  return {{"1/h(E X), every split at its mean", 1 / entropy},
          {"1/log 2, even splits", 1 / std::log(2.0)},
          {"1/log(1/min(EX,1-EX)), down the smaller side", -1 / std::log(std::min(p, 1 - p))}};
}

std::vector<ClaimPart> depth_parts(const GrowthLaw& law) {
  constexpr double largest = 1e12;
  auto parts = growth_parts_with_grid(
      "C6", law, {"bst", "beta(10,10)", "beta(10,80)", "patricia(0.23)"},
      {&statistic::depth, GrowthLadder::Rungs::means, GrowthLadder::Approach::settles, largest}, largest);
  std::ranges::move(depth_range_parts(parts.size() + 1), std::back_inserter(parts));
  return parts;
}

}  // namespace

Claim depth_claim() {
  const GrowthLaw law{"K96 Theorem 2.1; DK95 Theorem 1", "E D_n ~ log(n)/mu",
                      "nodes on the path to the last node, root counted", depth_constant, rival_depths};
  return growth_claim({"C6",
                       "D_n/log n -> 1/mu: depth of the last node of a random split tree",
                       law.source,
                       depth_parts(law),
                       {}},
                      {"C6_depth", "Depth of the last node", "mean D_n (nodes)"});
}

}  // namespace ramify
