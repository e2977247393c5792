#include "law_pictures.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ramify/config/size_grid.hpp"
#include "ramify/large/finite_means.hpp"
#include "ramify/large/large_orders.hpp"

namespace ramify {
namespace {

PlotSeries ratio_series(const OrderedCounts& orders, std::size_t longest) {
  PlotSeries series{orders.label};
  for (std::size_t k = 0; k + 1 < orders.counts.size(); ++k)
    series.points.push_back(
        {static_cast<double>(orders.lowest + k), orders.counts[k] / orders.counts[k + 1]});
  series.curve = series.points;
  if (orders.limit)
    series.guide = {{static_cast<double>(orders.lowest), *orders.limit},
                    {static_cast<double>(longest), *orders.limit}};
  return series;
}

/// The residual of a model, and the rival's line through its value at a size.
PlotSeries residual_series(const GrowthResidual& growth, const StatisticInfo& statistic) {
  constexpr Size smallest = 100, largest = 1'000'000'000;
  constexpr std::size_t steps = 337, given = 8;  // 48 a decade, and 8 sizes for which the laws are made
  constexpr double rival_from = 1e4;
  const FiniteMeans laws(growth.model, geometric_grid(smallest, largest, given));
  PlotSeries series{fmt::format("{}: less {:.6g} log n", growth.model.text(), growth.constant)};
  double at_rival = 0;
  for (const Size n : geometric_grid(smallest, largest, steps)) {
    const auto moments = laws.moments(statistic, n);
    if (!moments) continue;
    const auto size = static_cast<double>(n);
    series.curve.push_back({size, moments->mean - growth.constant * std::log(size)});
    if (size <= rival_from) at_rival = series.curve.back().y;
  }
  if (growth.rival)
    for (const double n : {rival_from, static_cast<double>(largest)})
      series.guide.push_back(
          {n, at_rival + (growth.rival->value - growth.constant) * std::log(n / rival_from)});
  if (growth.rival) series.label += fmt::format(" (dashed: {})", growth.rival->name);
  return series;
}

}  // namespace

std::vector<double> expected_counts(const Model& model, OrderCount::Of of, const Cancellation& cancellation) {
  constexpr double size = 1e12, fewest = 1e4;
  const LargeOrders orders(model, {size}, cancellation);
  const auto streams = orders.means(size, OrderCount::Of::streams), means = orders.means(size, of);
  std::vector<double> counts;
  for (std::size_t k = 0; k < means.size() && streams[k].value >= fewest; ++k)
    counts.push_back(means[k].value);
  return counts;
}

OrderedCounts expected_streams(const char* model, double limit, const Cancellation& cancellation) {
  return {fmt::format("{}: to {:.5g}", model, limit),
          expected_counts(Model::parse(model), OrderCount::Of::streams, cancellation), limit};
}

NamedPlot ratio_picture(const PlotNames& names, std::string_view subtitle,
                        const std::vector<OrderedCounts>& series) {
  std::size_t longest = 0;
  for (const auto& orders : series)
    if (orders.counts.size() > 1) longest = std::max(longest, orders.lowest + orders.counts.size() - 2);
  Plot plot{std::string(names.title), std::string(subtitle), "order k (leaf order 0)",
            std::string(names.y_label)};
  for (const auto& orders : series) plot.series.push_back(ratio_series(orders, longest));
  plot.whole_x = true;
  return {std::string(names.stem), std::move(plot)};
}

NamedPlot residual_picture(const PlotNames& names, const StatisticInfo& statistic,
                           const std::vector<GrowthResidual>& models) {
  Plot plot{std::string(names.title), "exact means less the claimed growth: level where that is right",
            "n (internal nodes)", std::string(names.y_label), true};
  for (const auto& growth : models) plot.series.push_back(residual_series(growth, statistic));
  return {std::string(names.stem), std::move(plot)};
}

}  // namespace ramify
