// C24 (K96 5.1.6, App. C): "neither method produced the correct bifurcation ratios"; random BSTs are
// "unsuitable for simulating the combinatorial structure of human lungs", whose bronchial tree has 2.74.
//   C24.1, C24.2  The ratio of terminal growth and that of segmental growth stay above 2.74: true.
//   C24.3  That much follows from the balance number, S_n <= B_n and Theorem C.2 (App. C): false. B_n
//   ~ 1.0262
//          log n, and not log_3 n (C19), leaves R >= 2.650 alone, below 2.74.
//   C24.4  The tree proposed instead, PATRICIA with p = 1/2.74, has that ratio: in the limit S_n ~ log_2.74
//   n.
// S_n ~ log n / log R, so that a growth constant is a ratio: evidence is that of C19 and C20.
#include <cmath>

#include "law_pictures.hpp"
#include "lung.hpp"
#include <fmt/format.h>

#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

constexpr const char* lung_source = "K96 5.1.6 and App. C";

/// The ratio R = e^(1/c) of what grows like c log n.
double ratio_of_growth(double c) {
  return std::exp(1 / c);
}

std::function<Basis(const Evidence&)> ratio_by_growth(const char* model, const GrowthLadder& ladder) {
  return [growth = growth_basis({Model::parse(model), ladder})](const Evidence& evidence) {
    Basis basis = growth(evidence);
    basis.estimate = ratio_of_growth(basis.estimate);
    basis.interval = {ratio_of_growth(basis.interval.upper), ratio_of_growth(basis.interval.lower)};
    basis.method = "e^(1/c), c the growth constant: " + basis.method;
    return basis;
  };
}

/// Above every number that is printed as 2.74.
Statement above_the_lung(int part, std::string text) {
  return {fmt::format("C24.{}", part),
          std::move(text),
          lung_source,
          "R, streams",
          Relation::at_least,
          "2.74 and its rounding",
          bronchial_tree.bifurcation.interval().upper,
          {},
          std::nullopt};
}

constexpr GrowthLadder order_ladder(const StatisticInfo& order, GrowthLadder::Approach approach,
                                    double largest) {
  return {&order, GrowthLadder::Rungs::medians, approach, largest};
}

Statement proposal(const Model& patricia) {
  const double p = patricia.parameters().front();
  const double first_ratio = 1 / (p * (1 - p) * depth_constant(patricia).value().value);
  return {
      "C24.4",
      "R = 2.74 in the limit, patricia(1/2.74)",
      "K96 5.1.6, Theorem B.3",
      "R, streams",
      Relation::equals,
      "2.74",
      ratio_of_growth(strahler_constant(patricia).value().value),
      {{"3, terminal growth as believed", 3}, {"h/(pq), the first ratio", first_ratio}, {"2, p = 1/2", 2}},
      std::nullopt};
}

/// Ratios of streams beside the lung's.
NamedPlot ratios_beside_the_lung(const Cancellation& cancellation) {
  std::vector<OrderedCounts> series;
  for (const char* model : {"catalan", "bst", "patricia(1/2.74)"})
    series.push_back(
        expected_streams(model, horton_ratio_constant(Model::parse(model)).value().value, cancellation));
  series.push_back({"bronchial tree: 2.74", {}, bronchial_tree.bifurcation.value});
  series.push_back({"pulmonary artery: 3.39", {}, pulmonary_artery.bifurcation.value});
  return ratio_picture({"C24_lung", "Stream ratios of growth models and of the lung", "M_k / M_(k+1)"},
                       "expected counts at n = 10^12; dashed: the limit, and what Cumming et al. measured",
                       series);
}

/// R(a,b) against b, a curve for each a.
NamedPlot map_of_ratios() {
  Plot plot{"Limiting stream ratio R(a,b) of beta splits",
            "by the travelling wave of docs/theory/horton-ratio.md; dashed: the bronchial tree", "b",
            "R(a,b)", true};
  constexpr double least = 0.25, step = 1.4142135623730951;
  constexpr int steps = 14;  // to b = 32
  for (const double a : {0.5, 1.0, 2.0, 5.0, 20.0}) {
    PlotSeries series{fmt::format("a = {}", a)};
    for (int i = 0; i <= steps; ++i) {
      const double b = least * std::pow(step, i);
      if (const auto ratio = horton_ratio_constant(Model::parse(fmt::format("beta({},{})", a, b))))
        series.curve.push_back({b, ratio->value});
    }
    plot.series.push_back(std::move(series));
  }
  const double lung = bronchial_tree.bifurcation.value;
  PlotSeries measured{"bronchial tree: 2.74"};
  measured.guide = {{least, lung}, {least * std::pow(step, steps), lung}};
  plot.series.push_back(std::move(measured));
  return {"C24_ratio_map", std::move(plot)};
}

std::vector<NamedPlot> lung_pictures(const Evidence& evidence) {
  return {ratios_beside_the_lung(evidence.cancellation), map_of_ratios()};
}

}  // namespace

Claim lung_claim() {
  using Approach = GrowthLadder::Approach;
  const StatisticInfo& order = statistic::strahler;
  Statement terminal = above_the_lung(1, "R of terminal growth lies above that of the lung, bst");
  terminal.rivals = {{"4, segmental growth", 4}};
  const Statement segmental = above_the_lung(2, "R of segmental growth lies above that of the lung, catalan");
  Statement balance = above_the_lung(3, "e^(1/c) lies above R of the lung where B_n ~ c log n, bst");
  balance.convention = "R >= e^(1/c) as S_n <= B_n";
  constexpr double orders = 1e12, balances = 1e30, patricia_orders = 1e60;
  const char* proposed = "patricia(1/2.74)";
  return {
      "C24",
      "Neither growth method has the lung's bifurcation ratio 2.74; PATRICIA trees have",
      lung_source,
      {part_without_trees(std::move(terminal),
                          ratio_by_growth("bst", order_ladder(order, Approach::settles, orders))),
       part_without_trees(segmental,
                          ratio_by_growth("catalan", order_ladder(order, Approach::settles, orders))),
       part_without_trees(
           std::move(balance),
           ratio_by_growth("bst", order_ladder(statistic::balance, Approach::drifts, balances))),
       part_without_trees(proposal(Model::parse(proposed)),
                          ratio_by_growth(proposed, order_ladder(order, Approach::drifts, patricia_orders)))},
      {},
      lung_pictures};
}

}  // namespace ramify
