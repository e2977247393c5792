#include "ramify/measure/horton_plot.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/estimate/centred_slope.hpp"

namespace ramify {
namespace {

/// The least-squares line through the logarithms, at the orders of the points.
struct FittedLine {
  std::vector<PlotPoint> points;
  double slope;  ///< of the natural logarithm, an order
};

/// Two points or more.
FittedLine fitted_line(const std::vector<PlotPoint>& points) {
  const auto count = static_cast<double>(points.size());
  double x = 0, y = 0;
  for (const PlotPoint& point : points) {
    x += point.x / count;
    y += std::log(point.y) / count;
  }
  CentredSlope slope(x);
  for (const PlotPoint& point : points) slope.add(point.x, std::log(point.y));
  FittedLine line{{}, slope.value()};
  for (const PlotPoint& point : points)
    line.points.push_back({point.x, std::exp(y + line.slope * (point.x - x))});
  return line;
}

/// Values of orders leaf_order, leaf_order + 1, ... that are above 0, with their line and its ratio, which is
/// above 1.
template <class Value>
PlotSeries horton_series(const std::string& label, const std::vector<Value>& values, unsigned leaf_order) {
  PlotSeries series{label};
  double order = leaf_order;
  for (const Value value : values) {
    if (value > 0) series.points.push_back({order, static_cast<double>(value)});
    ++order;
  }
  if (series.points.size() < 2) return series;
  FittedLine line = fitted_line(series.points);
  series.guide = std::move(line.points);
  series.label += fmt::format(": {} {:.4g} an order", line.slope < 0 ? "divided by" : "times",
                              std::exp(std::fabs(line.slope)));
  return series;
}

}  // namespace

Plot horton_plot(const std::vector<MeasuredOrders>& trees, unsigned leaf_order) {
  if (trees.size() > most_drawn_trees)
    throw Error(fmt::format("--plot of {} trees", trees.size()),
                fmt::format("a Horton diagram shows {} at most", most_drawn_trees),
                "take files with fewer, or leave --plot out");
  const bool is_one = trees.size() == 1;
  Plot plot{is_one ? fmt::format("Horton diagram of {}", trees.front().name) : "Horton diagram",
            fmt::format("leaf order {}; dashed: least-squares lines through the logarithms", leaf_order),
            "order", is_one ? "number; mean length and radius, in the file’s unit" : "number of streams"};
  plot.log_y = plot.whole_x = true;
  for (const MeasuredOrders& tree : trees) {
    plot.series.push_back(horton_series(is_one ? "streams" : tree.name, tree.streams, leaf_order));
    if (!is_one) continue;
    if (!tree.mean_lengths.empty())
      plot.series.push_back(horton_series("mean length", tree.mean_lengths, leaf_order));
    if (!tree.mean_radii.empty())
      plot.series.push_back(horton_series("mean radius", tree.mean_radii, leaf_order));
  }
  return plot;
}

}  // namespace ramify
