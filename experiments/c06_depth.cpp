// C6, Theorem 2.1 (Kruszewski 1996; Devroye 1998): the depth D_n of the last node of a random split tree
// satisfies D_n / log n -> 1/mu in probability and in mean, mu = E{X log(1/X) + (1-X) log(1/(1-X))}.
//
// Estimator: the slope of the sampled mean of D_n on log n. D_n/log n itself is off by constant/log n (5 %
// for BSTs at n = 4096) and is never judged.
#include "growth.hpp"

#include "ramify/theory/depth_constant.hpp"

namespace ramify {
namespace {

std::vector<GrowthClaim> parts() {
  std::vector<GrowthClaim> all;
  int number = 1;
  for (const char* model : {"bst", "beta(10,10)", "beta(10,80)", "patricia(0.23)"}) {
    all.push_back({"C6." + std::to_string(number++), "K96 Theorem 2.1",
                   std::string("E D_n ~ log(n)/mu, ") + model,
                   "nodes on the path to the last node, root counted", model, "depth",
                   depth_constant(Model::parse(model)).value().value, 0.05, Approach::settles, ""});
  }
  return all;
}

std::vector<Verdict> judge_depth(const std::vector<CheckedCell>& cells) {
  return judge_growth(parts(), cells);
}

std::vector<NamedPlot> plot_depth(const std::vector<CheckedCell>& cells) {
  return {{"C6_depth", growth_plot("Depth of the last node", "mean D_n (nodes)", parts(), cells)}};
}

}  // namespace

Claim depth_claim() {
  return {"C6", "D_n/log n -> 1/mu: depth of the last node of a random split tree",
          "K96 Theorem 2.1; DK95 Theorem 1", judge_depth, plot_depth};
}

}  // namespace ramify
