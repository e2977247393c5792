#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ramify/run/run_plots.hpp"

namespace ramify {
namespace {

std::string describe(const GrowthClaim& claim, const GrowthConstant& growth, Outcome outcome) {
  std::string text = fmt::format(
      "slope of the mean on log n, n = {:.0f}..{:.0f}; drift {:+.4f} (error {:.4f}) from the middle sizes; "
      "tolerance {:g} %",
      growth.slope.smallest_n, growth.slope.largest_n, growth.drift, growth.drift_error,
      100 * claim.tolerance);
  if (outcome != Outcome::inconclusive) return text;
  return text + "; " +
         (claim.approach == Approach::drifts ? claim.why_drifts
                                             : "the interval is too wide: more trees decide it");
}

/// "sampled means within 2.1 standard errors of the exact ones to n = 1000", or that no exact law was in
/// reach.
std::string exact_note(const ModelCells& model, const StatisticColumn& column) {
  double worst = 0;
  Size largest = 0;
  for (const auto& cell : model.cells) {
    for (std::size_t i = 0; i < cell.result.columns.size(); ++i) {
      if (cell.result.columns[i].column != column || !cell.checks[i]) continue;
      worst = std::max(worst, std::fabs(cell.checks[i]->z));
      largest = cell.result.n;
    }
  }
  if (largest == 0) return "no exact finite-n mean in reach";
  return fmt::format("sampled means within {:.1f} standard errors of the exact ones to n = {}", worst,
                     largest);
}

/// The line of the claimed slope through the last point.
std::vector<PlotPoint> law_through(const std::vector<SizedMean>& means, double theory) {
  std::vector<PlotPoint> law;
  const SizedMean& last = means.back();
  for (const auto& point : means) law.push_back({point.n, last.mean + theory * std::log(point.n / last.n)});
  return law;
}

/// Points, exact curve and claimed slope of one model; the slope as it is drawn, per factor of 10, and as the
/// sources give it.
PlotSeries growth_series(const GrowthCase& growth) {
  const double theory = growth.claim.theory;
  const std::string model = growth.model.model.text();
  const auto means = means_of(growth.model, growth.claim.statistic);
  PlotSeries series{
      fmt::format("{}: claimed {:.4g} log n, {:.4g} a decade", model, theory, theory * std::numbers::ln10)};
  for (const auto& point : means) series.points.push_back({point.n, point.mean, 2 * point.standard_error});
  series.curve = exact_means(growth.model.curves, model, growth.claim.statistic);
  series.guide = law_through(means, theory);
  series.look = growth.model.look;
  return series;
}

std::vector<GrowthCase> cases_of(const GrowthLaw& law, std::string_view id, const StatisticInfo& statistic,
                                 const std::vector<ModelCells>& models) {
  std::vector<GrowthCase> cases;
  for (const auto& model : models)
    cases.push_back(
        {{fmt::format("{}.{}", id, cases.size() + 1), std::string(law.source),
          fmt::format("{}, {}", law.statement, model.model.text()), std::string(law.convention), statistic,
          law.constant(model.model).value().value, law.tolerance, law.approach, std::string(law.why_drifts)},
         model});
  return cases;
}

}  // namespace

std::vector<SizedMean> means_of(const ModelCells& model, const StatisticColumn& column) {
  std::vector<SizedMean> means;
  for (const auto& cell : model.cells) {
    const auto& summary = cell.result.column(column);
    const double least_error = 1 / static_cast<double>(cell.result.replicates);
    means.push_back(
        {static_cast<double>(cell.result.n), summary.mean, std::max(summary.standard_error, least_error)});
  }
  return means;
}

Verdict judge_growth(const GrowthClaim& claim, const ModelCells& model) {
  const auto means = means_of(model, claim.statistic);
  const GrowthConstant growth = growth_constant(means);
  const Interval interval = growth_interval(growth, claim.approach);
  Outcome outcome = judge(interval, claim.theory, claim.tolerance * claim.theory);
  if (outcome == Outcome::refuted && claim.approach == Approach::drifts) outcome = Outcome::inconclusive;
  return {claim.id,
          claim.source,
          claim.statement,
          claim.convention,
          claim.theory,
          growth.slope.value,
          growth.slope.standard_error,
          interval.lower,
          interval.upper,
          static_cast<std::uint64_t>(means.back().n),
          outcome,
          describe(claim, growth, outcome) + "; " + exact_note(model, claim.statistic)};
}

NamedPlot growth_plot(const PlotNames& names, const std::vector<GrowthCase>& cases) {
  Plot plot{std::string(names.title),
            "points: sampled means, two standard errors; curves: exact; dashed: the claimed slope through "
            "the last point",
            "n (internal nodes)",
            std::string(names.y_label),
            true,
            false};
  for (const GrowthCase& growth : cases) plot.series.push_back(growth_series(growth));
  return {std::string(names.stem), std::move(plot)};
}

Claim growth_law_claim(Claim claim, const GrowthLaw& law, const PlotNames& plot) {
  const auto cases = [law, id = claim.id, statistic = claim.needs.statistic](const auto& models) {
    return cases_of(law, id, *statistic, models);
  };
  claim.judge = [cases](const std::vector<ModelCells>& models) {
    std::vector<Verdict> verdicts;
    for (const auto& [part, model] : cases(models)) verdicts.push_back(judge_growth(part, model));
    return verdicts;
  };
  claim.plots = [cases, plot](const std::vector<ModelCells>& models) {
    return std::vector<NamedPlot>{growth_plot(plot, cases(models))};
  };
  return claim;
}

}  // namespace ramify
