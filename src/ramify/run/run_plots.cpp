#include "ramify/run/run_plots.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace ramify {
namespace {

/// The series of a model, made where it is missing.
PlotSeries& series_of(std::vector<PlotSeries>& series, const std::string& model) {
  for (auto& line : series)
    if (line.label == model) return line;
  return series.emplace_back(PlotSeries{model, PlotSeries::Style::points_line, {}, {}});
}

std::vector<PlotSeries> means_by_model(const std::vector<CheckedCell>& cells,
                                       const StatisticInfo& statistic) {
  std::vector<PlotSeries> series;
  for (const auto& cell : cells) {
    auto& line = series_of(series, cell.result.model);
    const auto& summary = cell.result.column(statistic);
    line.points.push_back({static_cast<double>(cell.result.n), summary.mean, 2 * summary.standard_error});
  }
  for (auto& line : series)
    std::sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return series;
}

/// "n (internal nodes)"; "n" where the models count different things.
std::string size_label(const std::vector<CheckedCell>& cells, const Plan& plan) {
  std::set<std::string_view> counted;
  for (const auto& cell : cells) counted.insert(plan.cells[cell.number - 1].model.info().n_counts);
  return counted.size() == 1 ? fmt::format("n ({})", *counted.begin()) : "n";
}

}  // namespace

std::vector<std::pair<std::string, Plot>> run_plots(const std::vector<CheckedCell>& cells, const Plan& plan) {
  std::vector<std::pair<std::string, Plot>> plots;
  for (const auto* info : plan.statistics.chosen()) {
    if (info->shape != Columns::one || info->folds.empty()) continue;
    const std::string name(info->name);
    auto series = means_by_model(cells, *info);
    const bool has_line =
        std::any_of(series.begin(), series.end(), [](const auto& s) { return s.points.size() > 1; });
    if (!has_line) continue;
    plots.emplace_back(name, Plot{std::string(info->description), "sampled means with two standard errors",
                                  size_label(cells, plan), "mean " + name, true, false, std::move(series)});
  }
  return plots;
}

}  // namespace ramify
