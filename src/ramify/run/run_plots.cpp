#include "ramify/run/run_plots.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "ramify/core/find_named.hpp"
#include "ramify/model/registry.hpp"

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
std::string size_label(const std::vector<CheckedCell>& cells) {
  std::set<std::string_view> counted;
  for (const auto& cell : cells) {
    const std::string& model = cell.result.model;
    counted.insert(
        find_named(models(), &ModelInfo::name, model.substr(0, model.find('(')), "model").n_counts);
  }
  return counted.size() == 1 ? fmt::format("n ({})", *counted.begin()) : "n";
}

}  // namespace

std::vector<std::pair<std::string, Plot>> run_plots(const std::vector<CheckedCell>& cells,
                                                    const StatisticSet& statistics) {
  std::vector<std::pair<std::string, Plot>> plots;
  for (const auto* info : statistics.chosen()) {
    if (info->shape != Columns::one || info->folds.empty()) continue;
    const std::string name(info->name);
    auto series = means_by_model(cells, *info);
    const bool has_line =
        std::any_of(series.begin(), series.end(), [](const auto& s) { return s.points.size() > 1; });
    if (!has_line) continue;
    plots.emplace_back(name, Plot{std::string(info->description), "sampled means with two standard errors",
                                  size_label(cells), "mean " + name, true, false, std::move(series)});
  }
  return plots;
}

}  // namespace ramify
