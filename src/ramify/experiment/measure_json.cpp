#include "ramify/experiment/measure_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "ramify/core/number.hpp"
#include "ramify/experiment/registry_columns.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/statistic/stream_geometry.hpp"

namespace ramify {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  constexpr double exact_below = 9e15;  // whole numbers stay whole
  if (value == std::floor(value) && std::abs(value) < exact_below) return static_cast<std::int64_t>(value);
  return Json::parse(format_summary(value));
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json ratios_of(const std::vector<std::uint64_t>& counts) {
  if (counts.empty()) return nullptr;
  const OrderRatios ratios = order_ratios(counts);
  return {{"mean_ratio", number(ratios.mean_ratio)},
          {"pooled_ratio", number(pooled_over_orders(counts))},
          {"regression", number(ratios.regression)},
          {"geometric", number(ratios.geometric)}};
}

Json second_law(const std::vector<double>& means) {
  const MeanRatios ratios = mean_ratios(means);
  return {{"means", numbers(means)},
          {"mean_ratio", number(ratios.mean_ratio)},
          {"regression", number(ratios.regression)},
          {"geometric", number(ratios.geometric)}};
}

/// One column as a number, several as a list, pairs of orders as a list of rows.
void add_statistics(const TreeMeasurement& tree, unsigned leaf_order, Json& object) {
  for (const auto& column : detail::registry_columns(tree.orders.streams.size() - 1, leaf_order)) {
    const std::string name(column.statistic->name);
    const Json value = number(detail::value_of(column, tree, leaf_order));
    switch (column.statistic->shape) {
      case Columns::one:
        object[name] = value;
        break;
      case Columns::orders:
      case Columns::upper_orders:
        object[name].push_back(value);
        break;
      case Columns::pairs:
      case Columns::lower_pairs:
        if (column.place.low == 0) object[name].push_back(Json::array());
        object[name].back().push_back(value);
        break;
    }
  }
}

Json to_json(const TreeMeasurement& tree, unsigned leaf_order) {
  Json object{{"tree", tree.orders.name}, {"leaf_order", leaf_order}};
  object["ratios"] = {{"nodes", ratios_of(tree.orders.nodes)}, {"streams", ratios_of(tree.orders.streams)}};
  Json statistics = Json::object();
  add_statistics(tree, leaf_order, statistics);
  object["statistics"] = std::move(statistics);
  if (!tree.orders.mean_lengths.empty()) object["stream_length_law"] = second_law(tree.orders.mean_lengths);
  if (tree.orders.mean_radii.empty()) return object;
  object["stream_radius_law"] = second_law(tree.orders.mean_radii);
  if (tree.measures)
    object["murray"] = {{"exponent", number(tree.murray.median)},
                        {"forks", tree.murray.forks},
                        {"infinite", tree.murray.infinite}};
  return object;
}

}  // namespace

std::string measurement_json(const std::vector<TreeMeasurement>& trees, unsigned leaf_order) {
  Json list = Json::array();
  for (const TreeMeasurement& tree : trees) list.push_back(to_json(tree, leaf_order));
  constexpr int indent = 2;
  return list.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace ramify
