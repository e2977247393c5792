#include "ramify/design/height_map.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/design/depth_curve.hpp"
#include "ramify/design/design_row.hpp"

namespace ramify {
namespace {

Row map_row(const DepthCurve& curve) {
  Row row;
  row.exact(curve.depth());
  const auto [lowest, highest] = curve.heights();
  for (const HeightEnd& end : {lowest, highest}) {
    row.summary(end.height);
    if (end.split)
      row.text(beta_text({to_design_digits(end.split->a), to_design_digits(end.split->b)}));
    else
      row.text(fmt::format("split({})", format_significant(curve.end_fraction(), 12)));
  }
  return std::move(row.summary(curve.symmetric_height()));
}

std::vector<PlotPoint> heights_over_depths(const Table& map, std::string_view column) {
  std::vector<PlotPoint> points;
  for (std::size_t row = 0; row < map.rows(); ++row) {
    const double depth = map.number(row, "depth");
    points.push_back({depth, map.number(row, column) / depth});
  }
  return points;
}

}  // namespace

const std::vector<double>& map_depths() {
  static const std::vector<double> depths{1.45, 1.5, 1.6, 1.7, 1.8, 2,  2.25, 2.5, 3,  3.5,
                                          4,    5,   6,   8,   10,  15, 20,   30,  50, 100};
  return depths;
}

Table height_map(const std::vector<double>& depths, const ScanEffort& effort) {
  std::vector<std::optional<Row>> rows(depths.size());
  parallel_for(depths.size(), effort.threads, [&](std::size_t i, unsigned) {
    rows[i] = map_row(DepthCurve(depths[i], {1, effort.cancellation}));
  });
  Table map(
      {"depth", "lowest_height", "lowest_model", "highest_height", "highest_model", "symmetric_height"});
  for (auto& row : rows) map.add(*std::move(row));
  return map;
}

Plot height_map_plot(const Table& map) {
  Plot plot{
      "Depth and height that a beta tree can have together",
      "constants of the limit laws: depth D log n, height H log n; feasible is what lies between the curves",
      "depth D", "height over depth, H/D"};
  plot.log_x = true;
  const std::pair<const char*, const char*> series[] = {
      {"highest", "highest_height"}, {"beta(a,a)", "symmetric_height"}, {"lowest", "lowest_height"}};
  for (const auto& [label, column] : series) {
    PlotSeries drawn{label};
    drawn.curve = heights_over_depths(map, column);
    plot.series.push_back(std::move(drawn));
  }
  return plot;
}

}  // namespace ramify
