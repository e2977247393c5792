#include "ramify/accumulate/accumulator_json.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

using nlohmann::json;

json number(double value) {
  if (std::isfinite(value)) return value;
  return value > 0 ? "inf" : "-inf";
}

double to_real(const json& value) {
  if (!value.is_string()) return value.get<double>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return value.get<std::string>() == "inf" ? infinity : -infinity;
}

int128 to_whole(const json& value) {
  const auto& text = value.get_ref<const std::string&>();
  try {
    return int128(text);
  } catch (const std::exception&) {
    throw Error("'" + text + "'", "not a whole number of 128 bits", "grow the block again");
  }
}

}  // namespace

void to_json(json& j, const WholeSummary& summary) {
  j = summary.occurrences();
}

void from_json(const json& j, WholeSummary& summary) {
  summary = WholeSummary();
  for (const auto& pair : j) summary.add(pair.at(0).get<std::int64_t>(), pair.at(1).get<std::uint64_t>());
}

void to_json(json& j, const RealSummary& summary) {
  j = json::array();
  for (const double value : summary.values()) j.push_back(number(value));
}

void from_json(const json& j, RealSummary& summary) {
  summary = RealSummary();
  for (const auto& value : j) summary.add(to_real(value));
}

void to_json(json& j, const OrderTotals& totals) {
  json orders = json::array();
  for (const auto& order : totals.sums())
    orders.push_back({order.counts.str(), order.squares.str(), order.neighbours.str()});
  j = {{"trees", totals.trees()}, {"orders", std::move(orders)}};
}

void from_json(const json& j, OrderTotals& totals) {
  std::vector<OrderTotals::Sums> sums;
  for (const auto& order : j.at("orders"))
    sums.push_back({to_whole(order.at(0)), to_whole(order.at(1)), to_whole(order.at(2))});
  totals = OrderTotals(j.at("trees").get<std::uint64_t>(), sums);
}

}  // namespace ramify
