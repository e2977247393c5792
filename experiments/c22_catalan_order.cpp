// C22: the Horton-Strahler number of equiprobable binary trees (quoted in K96 B.1.2 from Flajolet, Raoult and
// Vuillemin 1979 and Kemp 1979): E S_n ~ log_4 n and Var S_n = O(1).
//
// E S_n = log_4 n + 0.2924 + an oscillation of amplitude 0.0407 with period 4 in n: along n 4^j every step
// adds exactly 1.
#include <algorithm>
#include <cmath>

#include "growth.hpp"

#include "ramify/compare/judge.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

constexpr const char* counted = "order of the root, leaf order 0";

GrowthClaim mean_growth(const Model& catalan) {
  return {"C22.1", "K96 B.1.2",         "E S_n ~ log_4 n, catalan",
          counted, statistic::strahler, strahler_constant(catalan).value().value,
          0.02,    Approach::settles,   ""};
}

/// Bounded variance: its slope on log n is 0. Standard error of a variance from its own spread: v
/// sqrt(2/trees) is near enough for two or three atoms, where the fourth moment is below three times the
/// squared variance; as that of a mean it is at least 1/trees.
Verdict bounded_variance(const ModelCells& catalan) {
  std::vector<SizedMean> variances;
  double largest = 0;
  for (const auto& cell : catalan.cells) {
    const double variance = cell.result.column(statistic::strahler).variance;
    largest = std::max(largest, variance);
    const double trees = static_cast<double>(cell.result.replicates);
    variances.push_back(
        {static_cast<double>(cell.result.n), variance, std::max(variance * std::sqrt(2 / trees), 1 / trees)});
  }
  const Slope slope = fit_slope(variances);
  const Interval interval = sampling_interval(slope.value, slope.standard_error);
  constexpr double tolerance = 0.01;
  const double fitted_rise = slope.value * std::log(slope.largest_n / slope.smallest_n);
  return {"C22.2",
          "K96 B.1.2",
          "Var S_n = O(1), catalan: slope of the variance on log n is 0",
          counted,
          0,
          slope.value,
          slope.standard_error,
          interval.lower,
          interval.upper,
          static_cast<std::uint64_t>(slope.largest_n),
          judge(interval, 0, tolerance),
          "slope of the sample variance on log n over all sizes, tolerance 0.01; variances up to " +
              std::to_string(largest) + ", fitted rise over the grid " + std::to_string(fitted_rise)};
}

std::vector<Verdict> judge_catalan_order(const std::vector<ModelCells>& models) {
  const ModelCells& catalan = models.front();
  return {judge_growth(mean_growth(catalan.model), catalan), bounded_variance(catalan)};
}

std::vector<NamedPlot> plot_catalan_order(const std::vector<ModelCells>& models) {
  const ModelCells& catalan = models.front();
  return {growth_plot(
      {"C22_catalan_order", "Horton-Strahler number of equiprobable trees", "mean S_n (leaf order 0)"},
      {{mean_growth(catalan.model), catalan}})};
}

}  // namespace

Claim catalan_order_claim() {
  return {"C22",
          "E S_n ~ log_4 n, Var S_n = O(1): Horton-Strahler number of equiprobable binary trees",
          "K96 B.1.2; Flajolet, Raoult, Vuillemin 1979",
          {&statistic::strahler, growth_sizes, "equiprobable binary trees, catalan", is_of<Catalan>},
          judge_catalan_order,
          plot_catalan_order};
}

}  // namespace ramify
