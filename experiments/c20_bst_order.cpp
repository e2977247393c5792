// C20: the Horton-Strahler number of random binary search trees.
//   C20.1  Theorem C.3: P{S_n >= (1+eps) log_3 n} -> 0.              True: the growth constant is below
//   1/log 3. C20.2  "believed to be tight", E S_n ~ log_3 n (5.1.6, App. C).  False: the constant is
//   1/log 3.0438. C20.3  E S_n <= log_3 n (3.2.2).                                 False at finite n (X71).
//
// E S_n oscillates by +-0.063 with period 3.0438 in n, and at n = 1000 it happens to be within 0.004 of log_3
// n: no single size can tell the two constants apart. The sizes of the config go up by that factor (the
// stream ratio of Kovchegov and Zaliapin 2017), so every step must add exactly 1 if S_n ~ log n / log 3.0438,
// and log 3.0438 / log 3 = 1.0132 if S_n ~ log_3 n.
#include <cmath>

#include "growth.hpp"

#include "ramify/compare/judge.hpp"
#include "ramify/run/run_plots.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {
namespace {

constexpr const char* convention = "order of the root, leaf order 0";
const double log_3_constant = 1 / std::log(3.0);

GrowthClaim tight() {
  return {"C20.2",    "K96 5.1.6 and App. C", "E S_n ~ log_3 n, bst (bound \"believed to be tight\")",
          convention, statistic::strahler,    log_3_constant,
          0.002,      Approach::settles,      ""};
}

/// One-sided: the whole interval of the growth constant lies at or below 1/log 3.
Verdict upper_bound(Verdict verdict) {
  verdict.claim = "C20.1";
  verdict.source = "K96 Theorem C.3";
  verdict.statement = "P{S_n >= (1+eps) log_3 n} -> 0, bst";
  verdict.outcome = verdict.upper <= log_3_constant  ? Outcome::reproduced
                    : verdict.lower > log_3_constant ? Outcome::refuted
                                                     : Outcome::inconclusive;
  verdict.method = "holds if the growth constant of E S_n is at most 1/log 3; S_n is within 1 of its mean; " +
                   verdict.method;
  return verdict;
}

/// E S_n - log_3 n at the size where it is clearest in standard errors; refuted where the interval is above
/// 0.
Verdict finite_bound(const std::vector<SizedMean>& means) {
  const SizedMean* clearest = &means.front();
  const auto excess = [](const SizedMean& point) { return point.mean - std::log(point.n) * log_3_constant; };
  for (const auto& point : means)
    if (excess(point) / point.standard_error > excess(*clearest) / clearest->standard_error)
      clearest = &point;
  const Interval interval = sampling_interval(excess(*clearest), clearest->standard_error);
  const Outcome outcome = interval.lower > 0 ? Outcome::refuted : Outcome::inconclusive;
  return {"C20.3",
          "K96 3.2.2",
          "E S_n - log_3 n <= 0, bst",
          convention,
          0,
          excess(*clearest),
          clearest->standard_error,
          interval.lower,
          interval.upper,
          static_cast<std::uint64_t>(clearest->n),
          outcome,
          "sampled mean minus log_3 n at the size where it is clearest; one finite n suffices to refute"};
}

std::vector<Verdict> judge_bst_order(const std::vector<ModelCells>& models) {
  const Verdict growth = judge_growth(tight(), models.front());
  return {upper_bound(growth), growth, finite_bound(means_of(models.front(), statistic::strahler))};
}

/// What is left of the mean when the law through the first point is taken off: level for the true constant
/// but for the oscillation, which the exact curve shows and the sizes, one in each period, do not.
PlotSeries residual(const std::string& label, double constant, const ModelCells& bst) {
  const auto means = means_of(bst, statistic::strahler);
  const SizedMean& first = means.front();
  const auto law = [&](double n) { return first.mean + constant * std::log(n / first.n); };
  PlotSeries series{label};
  for (const auto& point : means)
    series.points.push_back({point.n, point.mean - law(point.n), 2 * point.standard_error});
  series.curve = exact_means(bst.curves, bst.model.text(), statistic::strahler);
  for (auto& point : series.curve) point.y -= law(point.x);
  return series;
}

std::vector<NamedPlot> plot_bst_order(const std::vector<ModelCells>& models) {
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
                      {{tight(), bst}}),
          {"C20_bst_order_residual", plot}};
}

}  // namespace

Claim bst_order_claim() {
  return {"C20",
          "S_n <= (1+eps) log_3 n, believed tight: Horton-Strahler number of random BSTs",
          "K96 Theorem C.3, 3.2.2, 5.1.6",
          {&statistic::strahler, growth_sizes, "random binary search trees, bst", is_of<Bst>},
          judge_bst_order,
          plot_bst_order};
}

}  // namespace ramify
