#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "ramify/fit/ratio_table.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

/// exp of the unweighted least-squares slope of log diameter on order (Horton's law of diameters), where two
/// orders have one and it is above 1.
std::optional<PrintedRatio> diameter_ratio_of(const std::vector<double>& diameters) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < diameters.size(); ++k) {
    if (std::isnan(diameters[k])) continue;
    const double order = static_cast<double>(k), logarithm = std::log(diameters[k]);
    count += 1;
    x += order;
    y += logarithm;
    xx += order * order;
    xy += order * logarithm;
  }
  if (count < 2) return std::nullopt;
  const double ratio = std::exp((count * xy - x * y) / (count * xx - x * x));
  return ratio > 1 ? std::optional(PrintedRatio{ratio, 0}) : std::nullopt;
}

RatioDatum datum_of(const OrderCounts& orders, std::string_view file) {
  const OrderRatios ratios = order_ratios(orders.counts);
  RatioDatum datum;
  datum.name = std::filesystem::path(file).stem().string() + orders.name.substr(file.size());
  datum.where = {std::string(file), 0, 0};
  datum.ratio = ratios.mean_ratio;
  datum.observed[index_of(RatioEstimator::streams_mean_ratio)] = ratios.mean_ratio;
  datum.observed[index_of(RatioEstimator::streams_regression)] = ratios.regression;
  datum.observed[index_of(RatioEstimator::streams_geometric)] = ratios.geometric;
  datum.observed_by_law[index_of(LawEstimator::streams_pooled_ratio)] = pooled_over_orders(orders.counts);
  datum.observed_by_law[index_of(LawEstimator::streams_regression_of_means)] = ratios.regression;
  datum.branching = {ratios.regression, 0};
  datum.diameter_ratio = diameter_ratio_of(orders.diameters);
  datum.sizes = {{orders.counts.front() - 1, "counted", ""}};
  datum.warnings = orders.warnings;
  if (!(datum.ratio > 2)) {
    throw error_at(datum.where, fmt::format("mean ratio {}", datum.ratio),
                   "a stream of order k+1 begins where two of order k meet, so a ratio is above 2",
                   "give the number of streams of each order");
  }
  return datum;
}

}  // namespace

std::vector<RatioDatum> parse_order_table(SourceText source) {
  std::vector<RatioDatum> data;
  for (const OrderCounts& orders : read_order_counts(source)) data.push_back(datum_of(orders, source.name()));
  return data;
}

}  // namespace ramify
