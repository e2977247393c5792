// C22: the Horton-Strahler number of equiprobable binary trees (quoted in K96 B.1.2 from Flajolet, Raoult and
// Vuillemin 1979 and Kemp 1979): E S_n ~ log_4 n and Var S_n = O(1).
//
// E S_n = log_4 n + 0.2924 + an oscillation of amplitude 0.0407 with period 4 in n, and Var S_n oscillates
// with it: along n 4^j the mean goes up by exactly 1 and the variance stays, up to O(1/n). What is exact of
// both, and of the counts, is in c22_catalan_fluctuation.cpp and c22_catalan_counts.cpp.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "catalan_counts.hpp"
#include "law_pictures.hpp"

#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

constexpr const char* uniform_order = "order of the root, leaf order 0";
constexpr double largest_catalan = 1e12;

Statement mean_growth(const Model& catalan) {
  return {"C22.1",
          "E S_n ~ log_4 n, catalan",
          "K96 B.1.2",
          uniform_order,
          Relation::equals,
          "1/log 4",
          strahler_constant(catalan).value().value,
          {{"1/log 2, the ratio of nodes", 1 / std::log(2.0)},
           {"1/log 3.0438..., bst", strahler_constant(Model::parse("bst")).value().value}},
          std::nullopt};
}

/// The mean variance over a period is 0.1788 (Flajolet, Raoult, Vuillemin 1979).
Statement bounded_variance() {
  constexpr double variance = 0.1788, decades = 6;
  return {"C22.2",
          "Var S_n = O(1), catalan: slope of the variance on log n is 0",
          "K96 B.1.2",
          uniform_order,
          Relation::equals,
          "0",
          0,
          {{"a variance that doubles from n = 10^6 to 10^12", variance / (decades * std::log(10.0))}},
          std::nullopt};
}

std::vector<ClaimPart> catalan_order_parts() {
  using Rungs = GrowthLadder::Rungs;
  using Approach = GrowthLadder::Approach;
  const Model catalan = Model::parse("catalan");
  const StatisticInfo& order = statistic::strahler;
  std::vector<ClaimPart> parts{
      {mean_growth(catalan), catalan, &order,
       growth_basis({catalan, {&order, Rungs::medians, Approach::settles, largest_catalan}})},
      {bounded_variance(), catalan, &order,
       growth_basis({catalan, {&order, Rungs::variances, Approach::settles, largest_catalan}})}};
  for (auto more : {catalan_fluctuation_parts(), catalan_count_parts()})
    std::ranges::move(more, std::back_inserter(parts));
  return parts;
}

/// E S_n less its logarithm swings for ever: by a factor of 4 in n in uniform trees, of 3.0438 in BSTs, of
/// 1/p in PATRICIA trees.
std::vector<NamedPlot> order_fluctuations(const Evidence&) {
  std::vector<GrowthResidual> models;
  for (const char* text : {"bst", "catalan", "patricia(1/2.74)"}) {
    const Model model = Model::parse(text);
    models.push_back({model, strahler_constant(model).value().value});
  }
  return {residual_picture({"C22_order_fluctuation", "The Horton-Strahler number less its logarithm",
                            "mean S_n less log n / log R"},
                           statistic::strahler, models)};
}

}  // namespace

Claim catalan_order_claim() {
  return growth_claim(
      {"C22",
       "E S_n ~ log_4 n, Var S_n = O(1): Horton-Strahler number of equiprobable binary trees",
       "K96 B.1.2; Flajolet, Raoult, Vuillemin 1979",
       catalan_order_parts(),
       {},
       order_fluctuations},
      {"C22_catalan_order", "Horton-Strahler number of equiprobable trees", "mean S_n (leaf order 0)"});
}

}  // namespace ramify
