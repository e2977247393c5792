// C13 (Fact 3.4) and C17 (Theorem B.3): the Horton-Strahler number of a random PATRICIA tree satisfies
// S_n / log n -> 1 / log(1/min(p,q)) in probability.
//
// S_n is nearly deterministic and steps up by one about every factor 1/p in n, so sizes go up in that ratio
// (p = 1/2: its square) and the slope per step would be exactly 1 in the limit. What is left is a slow drift
// of the thresholds n_k (where P(S >= k) = 1/2): n_k p^k is not constant (theory.md section 5), by some 2 to
// 7 % of the slope at these sizes.
#include <algorithm>
#include <cmath>

#include "growth.hpp"

#include "ramify/model/registry.hpp"

namespace ramify {
namespace {

std::vector<GrowthClaim> parts() {
  std::vector<GrowthClaim> all;
  int number = 1;
  for (const char* text : {"patricia(1/2)", "patricia(1/2.74)", "patricia(0.23)", "patricia(1/4.8)"}) {
    const double p = Model::parse(text).parameters()[0];
    all.push_back({"C13." + std::to_string(number++), "K96 Fact 3.4, Theorem B.3",
                   std::string("S_n ~ log(n)/log(1/p), ") + text, "order of the root, leaf order 0", text,
                   "strahler", -1 / std::log(std::min(p, 1 - p)), 0.05, Approach::drifts,
                   "the thresholds n_k p^k still drift at these sizes"});
  }
  return all;
}

std::vector<Verdict> judge_order(const std::vector<CheckedCell>& cells) {
  return judge_growth(parts(), cells);
}

std::vector<NamedPlot> plot_order(const std::vector<CheckedCell>& cells) {
  return {{"C13_patricia_order", growth_plot("Horton-Strahler number of PATRICIA trees",
                                             "mean S_n (leaf order 0)", parts(), cells)}};
}

}  // namespace

Claim patricia_order_claim() {
  return {"C13", "S_n/log n -> 1/log(1/min(p,q)): Horton-Strahler number of random PATRICIA trees",
          "K96 Fact 3.4 and Theorem B.3", judge_order, plot_order};
}

}  // namespace ramify
