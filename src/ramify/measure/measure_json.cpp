#include "ramify/measure/measure_json.hpp"

#include <utility>

#include "ramify/core/json_text.hpp"
#include "ramify/io/json_writer.hpp"
#include "ramify/measure/column_value.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/statistic/statistic_set.hpp"
#include "ramify/statistic/stream_geometry.hpp"

namespace ramify {
namespace {

std::string json_numbers(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(json_number(value));
  return json_list(items);
}

std::string ratios_of(const std::vector<std::uint64_t>& counts) {
  if (counts.empty()) return "null";
  const OrderRatios ratios = order_ratios(counts);
  return json_line({{"mean_ratio", json_number(ratios.mean_ratio)},
                    {"pooled_ratio", json_number(pooled_over_orders(counts))},
                    {"regression", json_number(ratios.regression)},
                    {"geometric", json_number(ratios.geometric)}});
}

std::string second_law(const std::vector<double>& means) {
  const MeanRatios ratios = mean_ratios(means);
  return json_line({{"means", json_numbers(means)},
                    {"mean_ratio", json_number(ratios.mean_ratio)},
                    {"regression", json_number(ratios.regression)},
                    {"geometric", json_number(ratios.geometric)}});
}

/// One column as a number, several as a list, pairs of orders as a list of rows.
JsonMembers statistics_of(const TreeMeasurement& tree, unsigned leaf_order) {
  const auto columns = StatisticSet::all().columns(tree.orders.streams.size() - 1);
  JsonMembers members;
  for (std::size_t i = 0; i < columns.size();) {
    const StatisticInfo& statistic = *columns[i].statistic;
    const bool pairs = statistic.by_pairs();
    std::vector<std::string> rows;
    std::vector<double> row;
    for (; i < columns.size() && columns[i].statistic == &statistic; ++i) {
      if (pairs && columns[i].place.low == 0 && !row.empty())
        rows.push_back(json_numbers(std::exchange(row, {})));
      row.push_back(detail::value_of(columns[i], tree, leaf_order));
    }
    if (pairs) rows.push_back(json_numbers(row));
    const bool one = statistic.shape == Columns::one;
    members.emplace_back(statistic.name, one     ? json_number(row.front())
                                         : pairs ? json_list(rows)
                                                 : json_numbers(row));
  }
  return members;
}

std::string json_of(const TreeMeasurement& tree, unsigned leaf_order) {
  const std::string indent = "  ";
  JsonMembers members{{"tree", json_text(tree.orders.name)},
                      {"leaf_order", std::to_string(leaf_order)},
                      {"nodes_ratio_estimators", ratios_of(tree.orders.nodes)},
                      {"streams_ratio_estimators", ratios_of(tree.orders.streams)},
                      {"statistics", json_object(statistics_of(tree, leaf_order), indent + "  ")}};
  if (!tree.orders.mean_lengths.empty())
    members.emplace_back("stream_length_law", second_law(tree.orders.mean_lengths));
  if (!tree.orders.mean_radii.empty())
    members.emplace_back("stream_radius_law", second_law(tree.orders.mean_radii));
  if (!tree.orders.mean_areas.empty())
    members.emplace_back("stream_area_law", second_law(tree.orders.mean_areas));
  if (tree.measures && !tree.orders.mean_radii.empty())
    members.emplace_back("murray", json_line({{"exponent", json_number(tree.orders.murray.median)},
                                              {"forks", std::to_string(tree.orders.murray.forks)},
                                              {"infinite", std::to_string(tree.orders.murray.infinite)}}));
  return indent + json_object(members, indent);
}

}  // namespace

std::string measurement_json(const std::vector<TreeMeasurement>& trees, unsigned leaf_order) {
  std::vector<std::string> items;
  for (const TreeMeasurement& tree : trees) items.push_back(json_of(tree, leaf_order));
  return json_document(items);
}

}  // namespace ramify
