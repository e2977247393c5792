#include "ramify/run/run_plots.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "ramify/run/exact_check.hpp"

namespace ramify {
namespace {

const ExactCurve* find_curve(const std::vector<ExactCurve>& curves, std::string_view model,
                             const StatisticColumn& column) {
  const auto curve = std::ranges::find_if(
      curves, [&](const ExactCurve& each) { return each.model == model && each.column == column; });
  return curve == curves.end() ? nullptr : &*curve;
}

/// "n (internal nodes)"; "n" where the models count different things.
std::string size_label(const Plan& plan) {
  std::set<std::string_view> counted;
  for (const auto& cell : plan.cells) counted.insert(cell.model.info().n_counts);
  return counted.size() == 1 ? fmt::format("n ({})", *counted.begin()) : "n";
}

/// A logarithmic axis where values differ by decades: on a linear one the smaller ones would lie on 0.
bool differ_by_decades(const std::vector<PlotSeries>& series) {
  constexpr double decades = 100;
  double smallest = 0, largest = 0;
  for (const auto& one : series)
    for (const auto& point : one.points) {
      if (!(point.y > 0)) continue;
      smallest = smallest > 0 ? std::min(smallest, point.y) : point.y;
      largest = std::max(largest, point.y);
    }
  return largest >= decades * smallest && smallest > 0;
}

bool has_zeros(const std::vector<PlotSeries>& series) {
  return std::ranges::any_of(series, [](const auto& one) {
    return std::ranges::any_of(one.points, [](const auto& point) { return point.y <= 0; });
  });
}

/// Of a cell; nothing to draw where y is NaN.
using PointOf = std::function<PlotPoint(const CellResult&)>;
using CurveOf = std::function<std::vector<PlotPoint>(const std::string& model)>;

/// What a plot shows of every model.
struct Subject {
  std::string stem, title, convention, y_label;
  PointOf point;
  CurveOf curve;
};

/// Draws subjects, all from the cells of one run.
class Drawer {
 public:
  Drawer(const CheckedRun& run, const Plan& plan, const ModelLooks& looks)
      : run_(run), looks_(looks), x_label_(size_label(plan)) {}

  void draw(const Subject& subject) {
    auto series = series_of(subject);
    const auto is_line = [](const PlotSeries& one) { return one.points.size() > 1; };
    if (std::ranges::none_of(series, is_line)) return;
    const bool log_y = differ_by_decades(series);
    std::string subtitle = subject.convention;
    const bool has_curves =
        std::ranges::any_of(series, [](const PlotSeries& one) { return !one.curve.empty(); });
    if (has_curves) subtitle += "; curves: exact";
    if (log_y && has_zeros(series)) subtitle += "; values of 0 are not shown";
    plots_.push_back({subject.stem, Plot{subject.title, subtitle, x_label_, subject.y_label, true, log_y,
                                         std::move(series)}});
  }

  std::vector<NamedPlot> finished() { return std::move(plots_); }

 private:
  std::vector<PlotSeries> series_of(const Subject& subject) const {
    std::vector<PlotSeries> series;
    for (const auto& cell : run_.cells) {
      const std::string& model = cell.result.model;
      auto place = std::ranges::find(series, model, &PlotSeries::label);
      if (place == series.end()) {
        place = series.insert(series.end(), PlotSeries{model});
        place->curve = subject.curve(model);
        place->look = looks_.of(model);
      }
      const PlotPoint point = subject.point(cell.result);
      if (point.y == point.y) place->points.push_back(point);
    }
    for (auto& one : series) std::ranges::sort(one.points, {}, &PlotPoint::x);
    return series;
  }

  const CheckedRun& run_;
  const ModelLooks& looks_;
  std::string x_label_;
  std::vector<NamedPlot> plots_;
};

Subject mean_of(const StatisticInfo& statistic, const std::vector<ExactCurve>& curves) {
  return {std::string(statistic.name),
          statistic.title(),
          fmt::format("{}; points: sampled means, two standard errors", statistic.convention),
          fmt::format("mean {}", statistic.name),
          [&](const CellResult& cell) {
            const auto& summary = cell.column(statistic);
            return PlotPoint{static_cast<double>(cell.n), summary.mean, 2 * summary.standard_error};
          },
          [&](const std::string& model) { return exact_means(curves, model, statistic); }};
}

Subject variance_of(const StatisticInfo& statistic, const std::vector<ExactCurve>& curves) {
  return {fmt::format("{}_variance", statistic.name),
          statistic.title() + ", variance",
          fmt::format("{}; points: sample variances", statistic.convention),
          fmt::format("variance of {}", statistic.name),
          [&](const CellResult& cell) {
            return PlotPoint{static_cast<double>(cell.n), cell.column(statistic).variance};
          },
          [&](const std::string& model) {
            std::vector<PlotPoint> points;
            if (const ExactCurve* curve = find_curve(curves, model, statistic))
              for (const auto& [n, moments] : curve->points) points.push_back({n, moments.variance});
            return points;
          }};
}

/// E N_(k-1)/E N_k, of nodes or of streams.
Subject ratio_of(const StatisticInfo& counts, Estimate OrderSummary::* ratio, std::size_t order,
                 const std::vector<ExactCurve>& curves) {
  return {
      fmt::format("{}_ratio_{}", counts.name, order),
      fmt::format("Mean number of {0} of order {1} over that of order {2}", counts.name, order - 1, order),
      fmt::format("{}; points: ratios of sampled means, two standard errors", counts.convention),
      fmt::format("{} of order {} / order {}", counts.name, order - 1, order),
      [=](const CellResult& cell) {
        if (cell.orders.size() <= order) return PlotPoint{0, ColumnSummary::none};
        const Estimate& estimate = cell.orders[order - 1].*ratio;
        return PlotPoint{static_cast<double>(cell.n), estimate.value, 2 * estimate.standard_error};
      },
      [&curves, &counts, order](const std::string& model) {
        std::vector<PlotPoint> points = exact_means(curves, model, {counts, {order - 1}});
        const auto above = exact_means(curves, model, {counts, {order}});
        for (auto& point : points) {
          const auto same = std::ranges::find(above, point.x, &PlotPoint::x);
          point.y = same == above.end() ? ColumnSummary::none : point.y / same->y;
        }
        return points;
      }};
}

}  // namespace

std::vector<PlotPoint> exact_means(const std::vector<ExactCurve>& curves, std::string_view model,
                                   const StatisticColumn& column) {
  std::vector<PlotPoint> points;
  if (const ExactCurve* curve = find_curve(curves, model, column))
    for (const auto& [n, moments] : curve->points) points.push_back({n, moments.mean});
  return points;
}

std::vector<NamedPlot> run_plots(const CheckedRun& run, const Plan& plan, const ModelLooks& looks) {
  Drawer drawer(run, plan, looks);
  for (const auto* statistic : plan.statistics.chosen()) {
    if (statistic->shape != Columns::one || statistic->folds.empty()) continue;
    drawer.draw(mean_of(*statistic, run.curves));
    if (known_of(statistic->law.recurrence) >= Known::moments)
      drawer.draw(variance_of(*statistic, run.curves));
  }
  for (std::size_t order = 1; order <= highest_drawn_order; ++order) {
    if (plan.statistics.contains(statistic::nodes))
      drawer.draw(ratio_of(statistic::nodes, &OrderSummary::nodes_pooled_ratio, order, run.curves));
    if (plan.statistics.contains(statistic::streams))
      drawer.draw(ratio_of(statistic::streams, &OrderSummary::streams_pooled_ratio, order, run.curves));
  }
  return drawer.finished();
}

}  // namespace ramify
