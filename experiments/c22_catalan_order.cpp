// C22: the Horton-Strahler number of equiprobable binary trees (quoted in K96 B.1.2 from Flajolet, Raoult and
// Vuillemin 1979 and Kemp 1979): E S_n ~ log_4 n and Var S_n = O(1).
//
// E S_n = log_4 n + 0.2924 + an oscillation of amplitude 0.0407 with period 4 in n: along n 4^j every step
// adds exactly 1.
#include <algorithm>
#include <cmath>

#include "growth.hpp"

#include "ramify/compare/judge.hpp"

namespace ramify {
namespace {

constexpr const char* model = "catalan";

GrowthClaim mean_growth() {
  return {"C22.1",
          "K96 B.1.2",
          "E S_n ~ log_4 n, catalan",
          "order of the root, leaf order 0",
          model,
          "strahler",
          1 / std::log(4.0),
          0.02,
          Approach::settles,
          ""};
}

/// Bounded variance: its slope on log n is 0. Standard error of a variance from its own spread: v
/// sqrt(2/trees) is near enough for two or three atoms, where the fourth moment is below three times the
/// squared variance.
std::vector<Verdict> bounded_variance(const std::vector<CheckedCell>& cells) {
  std::vector<SizedMean> variances;
  double largest = 0;
  for (const auto& cell : cells_of(cells, model)) {
    const double variance = cell.result.column("strahler").variance;
    largest = std::max(largest, variance);
    variances.push_back({static_cast<double>(cell.result.n), variance,
                         variance * std::sqrt(2 / static_cast<double>(cell.result.replicates))});
  }
  if (variances.size() < 4) return {};
  const Slope slope = fit_slope(variances);
  const Interval interval = sampling_interval(slope.value, slope.standard_error);
  constexpr double tolerance = 0.01;
  const double fitted_rise = slope.value * std::log(slope.largest_n / slope.smallest_n);
  return {{"C22.2", "K96 B.1.2", "Var S_n = O(1), catalan: slope of the variance on log n is 0",
           "order of the root, leaf order 0", 0, slope.value, slope.standard_error, interval.lower,
           interval.upper, static_cast<std::uint64_t>(slope.largest_n), judge(interval, 0, tolerance),
           "slope of the sample variance on log n over all sizes, tolerance 0.01; variances up to " +
               std::to_string(largest) + ", fitted rise over the grid " + std::to_string(fitted_rise)}};
}

std::vector<Verdict> judge_order(const std::vector<CheckedCell>& cells) {
  std::vector<Verdict> verdicts = judge_growth({mean_growth()}, cells);
  for (auto& verdict : bounded_variance(cells)) verdicts.push_back(std::move(verdict));
  return verdicts;
}

std::vector<NamedPlot> plot_order(const std::vector<CheckedCell>& cells) {
  return {{"C22_catalan_order", growth_plot("Horton-Strahler number of equiprobable trees",
                                            "mean S_n (leaf order 0)", {mean_growth()}, cells)}};
}

}  // namespace

Claim catalan_order_claim() {
  return {"C22", "E S_n ~ log_4 n, Var S_n = O(1): Horton-Strahler number of equiprobable binary trees",
          "K96 B.1.2; Flajolet, Raoult, Vuillemin 1979", judge_order, plot_order};
}

}  // namespace ramify
