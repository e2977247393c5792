#include "ramify/measure/measure_json.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/number.hpp"
#include "ramify/measure/registry_columns.hpp"
#include "ramify/format/json_tree.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/statistic/stream_geometry.hpp"

namespace ramify {
namespace {

// Written as text, since a JSON library prints a double with up to 17 digits, and a long list on as many
// lines.

std::string number(double value) {
  return std::isfinite(value) ? format_summary(value) : "null";
}

std::string list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string numbers(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number(value));
  return list(items);
}

using Members = std::vector<std::pair<std::string, std::string>>;

/// A member a line, further in than what is around it.
std::string object(const Members& members, const std::string& indent) {
  std::vector<std::string> lines;
  for (const auto& [key, value] : members) lines.push_back(fmt::format("{}  \"{}\": {}", indent, key, value));
  return fmt::format("{{\n{}\n{}}}", fmt::join(lines, ",\n"), indent);
}

std::string on_one_line(const Members& members) {
  std::vector<std::string> items;
  for (const auto& [key, value] : members) items.push_back(fmt::format("\"{}\": {}", key, value));
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string ratios_of(const std::vector<std::uint64_t>& counts) {
  if (counts.empty()) return "null";
  const OrderRatios ratios = order_ratios(counts);
  return on_one_line({{"mean_ratio", number(ratios.mean_ratio)},
                      {"pooled_ratio", number(pooled_over_orders(counts))},
                      {"regression", number(ratios.regression)},
                      {"geometric", number(ratios.geometric)}});
}

std::string second_law(const std::vector<double>& means) {
  const MeanRatios ratios = mean_ratios(means);
  return on_one_line({{"means", numbers(means)},
                      {"mean_ratio", number(ratios.mean_ratio)},
                      {"regression", number(ratios.regression)},
                      {"geometric", number(ratios.geometric)}});
}

/// One column as a number, several as a list, pairs of orders as a list of rows.
Members statistics_of(const TreeMeasurement& tree, unsigned leaf_order) {
  const auto columns = detail::registry_columns(tree.orders.streams.size() - 1, leaf_order);
  Members members;
  for (std::size_t i = 0; i < columns.size();) {
    const StatisticInfo& statistic = *columns[i].statistic;
    const bool pairs = statistic.by_pairs();
    std::vector<std::string> rows;
    std::vector<double> row;
    for (; i < columns.size() && columns[i].statistic == &statistic; ++i) {
      if (pairs && columns[i].place.low == 0 && !row.empty()) rows.push_back(numbers(std::exchange(row, {})));
      row.push_back(detail::value_of(columns[i], tree, leaf_order));
    }
    if (pairs) rows.push_back(numbers(row));
    const bool one = statistic.shape == Columns::one;
    members.emplace_back(statistic.name, one ? number(row.front()) : pairs ? list(rows) : numbers(row));
  }
  return members;
}

std::string json_of(const TreeMeasurement& tree, unsigned leaf_order) {
  const std::string indent = "  ";
  Members members{{"tree", json_text(tree.orders.name)},
                  {"leaf_order", std::to_string(leaf_order)},
                  {"nodes_ratio_estimators", ratios_of(tree.orders.nodes)},
                  {"streams_ratio_estimators", ratios_of(tree.orders.streams)},
                  {"statistics", object(statistics_of(tree, leaf_order), indent + "  ")}};
  if (!tree.orders.mean_lengths.empty())
    members.emplace_back("stream_length_law", second_law(tree.orders.mean_lengths));
  if (!tree.orders.mean_radii.empty())
    members.emplace_back("stream_radius_law", second_law(tree.orders.mean_radii));
  if (tree.measures && !tree.orders.mean_radii.empty())
    members.emplace_back("murray", on_one_line({{"exponent", number(tree.murray.median)},
                                                {"forks", std::to_string(tree.murray.forks)},
                                                {"infinite", std::to_string(tree.murray.infinite)}}));
  return indent + object(members, indent);
}

}  // namespace

std::string measurement_json(const std::vector<TreeMeasurement>& trees, unsigned leaf_order) {
  std::vector<std::string> items;
  for (const TreeMeasurement& tree : trees) items.push_back(json_of(tree, leaf_order));
  return fmt::format("[\n{}\n]\n", fmt::join(items, ",\n"));
}

}  // namespace ramify
