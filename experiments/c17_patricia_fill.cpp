// C17 (Corollary B.2 with Theorem B.2): the fill level of a random PATRICIA tree grows like S_n: F_n / log n
// -> 1 / log(1/min(p,q)).
//
// F <= S <= B holds in every tree (Lemmas B.3, B.4), so F has the limit of S; it comes from below, with a log
// log n term (Devroye 1992 for p = 1/2), which is why p = 1/2 is the slowest.
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
    all.push_back({"C17." + std::to_string(number++), "K96 Corollary B.2",
                   std::string("F_n ~ log(n)/log(1/p), ") + text,
                   "deepest full level, root at level 0, external nodes counted", text, "fill_level",
                   -1 / std::log(std::min(p, 1 - p)), 0.05, Approach::drifts,
                   "a log log n term is left at these sizes"});
  }
  return all;
}

std::vector<Verdict> judge_fill(const std::vector<CheckedCell>& cells) {
  return judge_growth(parts(), cells);
}

std::vector<NamedPlot> plot_fill(const std::vector<CheckedCell>& cells) {
  return {{"C17_patricia_fill",
           growth_plot("Fill level of PATRICIA trees", "mean F_n (levels)", parts(), cells)}};
}

}  // namespace

Claim patricia_fill_claim() {
  return {"C17", "F_n/log n -> 1/log(1/min(p,q)): fill level of random PATRICIA trees", "K96 Corollary B.2",
          judge_fill, plot_fill};
}

}  // namespace ramify
