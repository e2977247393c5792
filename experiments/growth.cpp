#include "growth.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

Verdict judge_one(const GrowthClaim& claim, const std::vector<SizedMean>& means, const std::string& exact) {
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
          describe(claim, growth, outcome) + "; " + exact};
}

PlotSeries law_through(const GrowthClaim& claim, const std::vector<SizedMean>& means) {
  PlotSeries law{
      fmt::format("{}: slope {:.4g}", claim.model, claim.theory), PlotSeries::Style::dashed, {}, {}};
  const SizedMean& last = means.back();
  for (const auto& point : means)
    law.points.push_back({point.n, last.mean + claim.theory * std::log(point.n / last.n), 0});
  return law;
}

}  // namespace

std::vector<CheckedCell> cells_of(const std::vector<CheckedCell>& cells, std::string_view model) {
  std::vector<CheckedCell> chosen;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(chosen),
               [&](const CheckedCell& cell) { return cell.result.model == model; });
  std::sort(chosen.begin(), chosen.end(),
            [](const auto& a, const auto& b) { return a.result.n < b.result.n; });
  return chosen;
}

std::vector<SizedMean> means_of(const std::vector<CheckedCell>& cells, std::string_view model,
                                const std::string& column) {
  std::vector<SizedMean> means;
  for (const auto& cell : cells_of(cells, model)) {
    const auto& summary = cell.result.column(column);
    const double least_error = 1 / static_cast<double>(cell.result.replicates);
    means.push_back(
        {static_cast<double>(cell.result.n), summary.mean, std::max(summary.standard_error, least_error)});
  }
  return means;
}

std::string exact_note(const std::vector<CheckedCell>& cells, std::string_view model,
                       const std::string& column) {
  double worst = 0;
  Size largest = 0;
  for (const auto& cell : cells_of(cells, model)) {
    for (std::size_t i = 0; i < cell.result.columns.size(); ++i) {
      if (cell.result.columns[i].name != column || !cell.checks[i]) continue;
      worst = std::max(worst, std::fabs(cell.checks[i]->z));
      largest = cell.result.n;
    }
  }
  if (largest == 0) return "no exact finite-n mean in reach";
  return fmt::format("sampled means within {:.1f} standard errors of the exact ones to n = {}", worst,
                     largest);
}

std::vector<Verdict> judge_growth(const std::vector<GrowthClaim>& claims,
                                  const std::vector<CheckedCell>& cells) {
  std::vector<Verdict> verdicts;
  for (const auto& claim : claims) {
    const auto means = means_of(cells, claim.model, claim.statistic);
    if (means.size() >= 4)
      verdicts.push_back(judge_one(claim, means, exact_note(cells, claim.model, claim.statistic)));
  }
  return verdicts;
}

std::vector<PlotSeries> growth_series(const GrowthClaim& claim, const std::vector<CheckedCell>& cells) {
  const auto means = means_of(cells, claim.model, claim.statistic);
  if (means.empty()) return {};
  PlotSeries sampled{claim.model, PlotSeries::Style::points, {}, {}};
  for (const auto& point : means) sampled.points.push_back({point.n, point.mean, 2 * point.standard_error});
  return {sampled, law_through(claim, means)};
}

Plot growth_plot(const std::string& title, const std::string& y_label, const std::vector<GrowthClaim>& claims,
                 const std::vector<CheckedCell>& cells) {
  Plot plot{
      title,
      "points: sampled means with two standard errors; dashed: the claimed slope through the last point",
      "n (internal nodes)",
      y_label,
      true,
      false,
      {}};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    for (auto& series : growth_series(claims[i], cells)) {
      series.color = i;
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

}  // namespace ramify
