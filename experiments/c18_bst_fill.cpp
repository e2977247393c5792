// C18, Theorem C.1 (Devroye 1986): the fill level of a random binary search tree satisfies F_n / log n ->
// 0.3733..., the smaller root of c log(2e/c) = 1.
//
// F_n is a pulled front, as the height is: at n = 65536 F_n/log n is still 0.54, and its slope 0.38. The
// sizes at which the median goes up, to 10^100, give the constant to 4 digits.
#include <cmath>

#include "growth.hpp"

#include "ramify/theory/fill_level_constant.hpp"
#include "ramify/theory/height_constant.hpp"

namespace ramify {
namespace {

std::vector<NamedValue> rival_fill_levels(const Model& model) {
  return {{"the larger root, the height", height_constant(model).value().value},
          {"1/log(2e), its first approximation", 1 / (1 + std::log(2.0))},
          {"1/3, by eye at n = 10^9", 1.0 / 3}};
}

}  // namespace

Claim bst_fill_claim() {
  const GrowthLaw law{"K96 Theorem C.1; Devroye 1986", "F_n/log n -> 0.3733...",
                      "deepest full level, root at level 0, external nodes counted", fill_level_constant,
                      rival_fill_levels};
  const GrowthCase bst{
      Model::parse("bst"),
      {&statistic::fill_level, GrowthLadder::Rungs::medians, GrowthLadder::Approach::drifts, 1e100}};
  return growth_claim({"C18",
                       "F_n/log n -> 0.3733...: fill level of random BSTs",
                       law.source,
                       growth_parts("C18", law, {bst}),
                       {}},
                      {"C18_bst_fill", "Fill level of random binary search trees", "mean F_n (levels)"});
}

}  // namespace ramify
