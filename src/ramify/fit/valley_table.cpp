#include "ramify/fit/valley_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

namespace ramify {
namespace {

constexpr int valley_digits = 6;

std::string_view name_of(ValleyPoint::Place place) {
  switch (place) {
    case ValleyPoint::Place::estimate:
      return "estimate";
    case ValleyPoint::Place::end:
      return "end";
    case ValleyPoint::Place::open_end:
      return "open end";
    case ValleyPoint::Place::between:
      break;
  }
  return "";
}

/// look(datum, fit) of all fits that have a valley.
template <class Look>
void each_valley(std::span<const FittedDatum> data, Look look) {
  for (const FittedDatum& datum : data)
    for (const FamilyFit& fit : datum.fits)
      if (!fit.valley.empty()) look(datum, fit);
}

PlotSeries series_of(const FittedDatum& datum, const FamilyFit& fit) {
  PlotSeries series{fmt::format("{}, {}", datum.data, fit.family->name)};
  for (const ValleyPoint& point : fit.valley) {
    series.curve.push_back({point.a, point.b});
    if (point.place == ValleyPoint::Place::estimate) series.points.push_back({point.a, point.b});
  }
  return series;
}

}  // namespace

Table valley_table(std::span<const FittedDatum> data) {
  Table table({"data", "model", "a", "b", "horton_ratio", "log_likelihood", "below_best", "place"});
  each_valley(data, [&table](const FittedDatum& datum, const FamilyFit& fit) {
    double best = -std::numeric_limits<double>::infinity();
    for (const ValleyPoint& point : fit.valley) best = std::max(best, point.log_likelihood);
    for (const ValleyPoint& point : fit.valley) {
      Row row;
      row.text(datum.data).text(fit.family->name).significant(point.a, valley_digits);
      row.significant(point.b, valley_digits).significant(point.horton_ratio, valley_digits);
      row.fixed(point.log_likelihood, 4).fixed(best - point.log_likelihood, 4).text(name_of(point.place));
      table.add(std::move(row));
    }
  });
  return table;
}

Plot valley_plot(std::span<const FittedDatum> data) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  Plot plot{"Shapes (a,b) that fit nearly as well", "", "a", "b, at least a", true, true};
  each_valley(data, [&](const FittedDatum& datum, const FamilyFit& fit) {
    plot.series.push_back(series_of(datum, fit));
    for (const ValleyPoint& point : fit.valley) {
      low = std::fmin(low, point.horton_ratio);
      high = std::fmax(high, point.horton_ratio);
    }
  });
  plot.subtitle = fmt::format(
      "95 % region along the valley of the likelihood; points: estimates; R(a,b) {:.3g} "
      "to {:.3g}",
      low, high);
  return plot;
}

}  // namespace ramify
