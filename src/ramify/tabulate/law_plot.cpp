#include "ramify/tabulate/law_plot.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// Probabilities below this part of the largest, and mean counts below least_count, are not drawn.
constexpr double least_part = 1e-4, least_count = 1e-3;

std::string label_of(double n) {
  return n < 1e7 ? fmt::format("n = {:.0f}", n) : fmt::format("n = {:g}", n);
}

/// The points of one size: x and y are columns of the table.
std::vector<PlotPoint> points_of(const Table& law, double n, std::string_view x, std::string_view y) {
  std::vector<PlotPoint> points;
  for (std::size_t row = 0; row < law.rows(); ++row)
    if (law.number(row, "n") == n) points.push_back({law.number(row, x), law.number(row, y)});
  return points;
}

void drop_below(std::vector<PlotPoint>& points, double least) {
  std::erase_if(points, [least](const PlotPoint& point) { return !(point.y >= least); });
}

/// The points and a 0 at either end: few values would else look like a piece of a line.
std::vector<PlotPoint> down_to_zero(std::vector<PlotPoint> points) {
  if (points.empty()) return points;
  const PlotPoint before{points.front().x - 1, 0}, after{points.back().x + 1, 0};
  points.insert(points.begin(), before);
  points.push_back(after);
  return points;
}

double highest(const std::vector<PlotPoint>& points) {
  return points.empty() ? 0 : std::ranges::max_element(points, {}, &PlotPoint::y)->y;
}

Plot distribution(const LawRequest& request, const Table& law) {
  const StatisticInfo& statistic = *request.subject.statistics.front();
  Plot plot{fmt::format("{} of {}", statistic.title(), request.model.text()),
            fmt::format("exact law; {}; without probabilities below {:g} of the largest",
                        statistic.convention, least_part),
            std::string(statistic.name), "probability"};
  plot.whole_x = true;
  for (const double n : request.sizes) {
    PlotSeries series{label_of(n), points_of(law, n, "value", "probability")};
    drop_below(series.points, least_part * highest(series.points));
    if (request.sizes.size() == 1)
      series.mark = PlotSeries::Mark::bar;
    else
      series.curve = down_to_zero(series.points);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Plot mean_counts(const LawRequest& request, const Table& law) {
  Plot plot{fmt::format("Mean numbers of nodes and streams by order, {}", request.model.text()),
            fmt::format("exact; leaf order 0; without means below {:g}", least_count), "order",
            "mean number"};
  plot.log_y = plot.whole_x = true;
  for (const double n : request.sizes)
    for (const auto* counted : {"nodes", "streams"}) {
      PlotSeries series{fmt::format("{}, {}", counted, label_of(n)),
                        points_of(law, n, "order", fmt::format("mean_{}", counted))};
      drop_below(series.points, least_count);
      plot.series.push_back(std::move(series));
    }
  return plot;
}

}  // namespace

void require_drawable(const LawRequest& request) {
  if (request.quantity != LawQuantity::law)
    throw Error(fmt::format("--plot with {}",
                            request.quantity == LawQuantity::moments ? "--moments" : "--covariances"),
                "laws and the mean counts of orders are drawn", "leave one of them out");
  if (request.sizes.size() > most_drawn_sizes)
    throw Error(fmt::format("--plot of {} sizes", request.sizes.size()),
                fmt::format("a picture shows {} at most", most_drawn_sizes), "take fewer with --n");
}

Plot law_plot(const LawRequest& request, const Table& law) {
  return request.subject.is_orders() ? mean_counts(request, law) : distribution(request, law);
}

}  // namespace ramify
