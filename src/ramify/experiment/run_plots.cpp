#include "ramify/experiment/run_plots.hpp"

#include <algorithm>
#include <map>

namespace ramify {
namespace {

/// The series of a model, made where it is missing.
PlotSeries& series_of(std::vector<PlotSeries>& series, const std::string& model) {
  for (auto& line : series)
    if (line.label == model) return line;
  return series.emplace_back(PlotSeries{model, PlotSeries::Style::points_line, {}, {}});
}

std::vector<PlotSeries> means_by_model(const std::vector<CheckedCell>& cells, const std::string& column) {
  std::vector<PlotSeries> series;
  for (const auto& cell : cells) {
    auto& line = series_of(series, cell.result.model);
    const auto& summary = cell.result.column(column);
    line.points.push_back({static_cast<double>(cell.result.n), summary.mean, 2 * summary.standard_error});
  }
  for (auto& line : series)
    std::sort(line.points.begin(), line.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return series;
}

}  // namespace

std::vector<std::pair<std::string, Plot>> run_plots(const std::vector<CheckedCell>& cells,
                                                    const StatisticSet& statistics) {
  std::vector<std::pair<std::string, Plot>> plots;
  for (const auto* info : statistics.chosen()) {
    if (info->shape != Columns::one || info->name == "size") continue;
    const std::string name(info->name);
    auto series = means_by_model(cells, name);
    const bool has_line =
        std::any_of(series.begin(), series.end(), [](const auto& s) { return s.points.size() > 1; });
    if (!has_line) continue;
    plots.emplace_back(name, Plot{std::string(info->description), "sampled means with two standard errors",
                                  "n (internal nodes)", "mean " + name, true, false, std::move(series)});
  }
  return plots;
}

}  // namespace ramify
