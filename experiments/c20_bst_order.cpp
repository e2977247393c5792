// C20: the Horton-Strahler number of random binary search trees.
//   C20.1  Theorem C.3: P{S_n >= (1+eps) log_3 n} -> 0.              True: the growth constant is below
//   1/log 3. C20.2  "believed to be tight", E S_n ~ log_3 n (5.1.6, App. C).  False: the constant is
//   1/log 3.0438. C20.3  E S_n <= log_3 n (3.2.2).                                 False at finite n (X71).
//
// E S_n oscillates by +-0.063 with period 3.0438 in n, and at n = 1000 it happens to be within 0.004 of log_3
// n: no single size can tell the two constants apart. The sizes n_k at which the median reaches k do not
// oscillate: n_{k+1}/n_k settles at the stream ratio of Kovchegov and Zaliapin (2017), which enters nowhere,
// to 8 digits at n = 10^12.
#include <cmath>

#include "growth.hpp"
#include <fmt/format.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/statistic_law.hpp"
#include "ramify/run/run_plots.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

constexpr const char* convention = "order of the root, leaf order 0";
const double log_3_constant = 1 / std::log(3.0);

GrowthCase bst_order() {
  return {Model::parse("bst"),
          {&statistic::strahler, GrowthLadder::Rungs::medians, GrowthLadder::Approach::settles, 1e12}};
}

/// One-sided: what holds of a growth constant at most 1/log 3, S_n staying within O(1) of its median.
Statement upper_bound() {
  return {"C20.1",           "P{S_n >= (1+eps) log_3 n} -> 0, bst",
          "K96 Theorem C.3", convention,
          Relation::at_most, "1/log 3",
          log_3_constant,    {{"1/log 4, uniform trees", 1 / std::log(4.0)}},
          std::nullopt};
}

Statement tight_bound(const Model& bst) {
  return {"C20.2",
          "E S_n ~ log_3 n, bst (bound \"believed to be tight\")",
          "K96 5.1.6 and App. C",
          convention,
          Relation::equals,
          "1/log 3",
          log_3_constant,
          {{"1/log 2, 1/E X in place of the ratio", 1 / std::log(2.0)}},
          NamedValue{"1/log 3.0438...", strahler_constant(bst).value().value}};
}

Statement finite_bound() {
  return {"C20.3",     "E S_n - log_3 n <= 0, bst", "K96 3.2.2", convention, Relation::at_most, "0", 0, {},
          std::nullopt};
}

/// The largest E S_n - log_3 n over all n from 2 on, by the exact law.
Basis largest_excess(const Model& bst, const Cancellation& cancellation) {
  constexpr Size largest = 4096, smallest = 2;
  const auto law =
      build_law(bst, largest, StatisticLaw(statistic::strahler.law.recurrence, largest), cancellation);
  double worst = -HUGE_VAL;
  Size where = 0, last = 0;
  for (Size n = smallest; n <= largest; ++n) {
    const double excess = law.moments(n).mean - std::log(static_cast<double>(n)) * log_3_constant;
    if (excess > worst) {
      worst = excess;
      where = n;
    }
    if (excess > 0) last = n;
  }
  constexpr double error = 1e-12;
  return {
      EvidenceKind::exact,
      Standing::proved,
      worst,
      {worst - error, worst + error},
      static_cast<double>(largest),
      fmt::format("exact E S_n - log_3 n at every n from {} to {}: largest at n = {}, above 0 up to n = {}",
                  smallest, largest, where, last),
      ""};
}

std::vector<ClaimPart> bst_order_parts() {
  const GrowthCase growth = bst_order();
  const auto constant = growth_basis(growth);
  const auto excess = [bst = growth.model](const Evidence& evidence) {
    return largest_excess(bst, evidence.cancellation);
  };
  return {{upper_bound(), growth.model, &statistic::strahler, constant},
          {tight_bound(growth.model), growth.model, &statistic::strahler, constant},
          {finite_bound(), growth.model, &statistic::strahler, excess}};
}

/// What is left of the mean when the law through the first point is taken off: level for the true constant
/// but for the oscillation, which the exact curve shows and the sizes, one in each period, do not.
PlotSeries residual(const std::string& label, double constant, const ModelCells& bst) {
  PlotSeries series{label};
  series.points = sampled_means(bst, statistic::strahler);
  const PlotPoint first = series.points.front();
  const auto law = [&](double n) { return first.y + constant * std::log(n / first.x); };
  for (auto& point : series.points) point.y -= law(point.x);
  series.curve = exact_means(bst.curves, bst.model.text(), statistic::strahler);
  for (auto& point : series.curve) point.y -= law(point.x);
  return series;
}

std::vector<NamedPlot> plot_bst_order(const std::vector<ClaimPart>& parts,
                                      const std::vector<ModelCells>& models) {
  const ModelCells& bst = models.front();
  Plot plot{
      "Horton-Strahler number of random binary search trees",
      "mean minus the law through the first point: level where it holds; points: sampled; curves: exact",
      "n (internal nodes)",
      "mean S_n (leaf order 0) minus law",
      true,
      false};
  plot.series.push_back(residual("minus log n / log 3: the thesis", log_3_constant, bst));
  plot.series.push_back(residual("minus log n / log 3.0438: Kovchegov and Zaliapin's ratio",
                                 strahler_constant(bst.model).value().value, bst));
  return {growth_plot({"C20_bst_order", "Horton-Strahler number of random binary search trees",
                       "mean S_n (leaf order 0)"},
                      parts, models),
          {"C20_bst_order_residual", plot}};
}

}  // namespace

Claim bst_order_claim() {
  const auto parts = bst_order_parts();
  return {"C20", "S_n <= (1+eps) log_3 n, believed tight: Horton-Strahler number of random BSTs",
          "K96 Theorem C.3, 3.2.2, 5.1.6", parts,
          [parts](const std::vector<ModelCells>& models) { return plot_bst_order(parts, models); }};
}

}  // namespace ramify
