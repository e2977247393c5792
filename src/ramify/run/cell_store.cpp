#include "ramify/run/cell_store.hpp"

#include <array>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ramify/core/version.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

using nlohmann::json;

// JSON has no NaN: the ratio above the top order is null.
json number(double value) {
  return value == value ? json(value) : json(nullptr);
}
double number(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

json to_json(const Estimate& estimate) {
  return {number(estimate.value), number(estimate.standard_error)};
}
Estimate to_estimate(const json& pair) {
  return {number(pair.at(0)), number(pair.at(1))};
}

constexpr std::array<std::pair<const char*, double ColumnSummary::*>, 8> column_numbers{
    {{"mean", &ColumnSummary::mean},
     {"standard_error", &ColumnSummary::standard_error},
     {"variance", &ColumnSummary::variance},
     {"min", &ColumnSummary::min},
     {"q05", &ColumnSummary::q05},
     {"q50", &ColumnSummary::q50},
     {"q95", &ColumnSummary::q95},
     {"max", &ColumnSummary::max}}};

json to_json(const ColumnSummary& c) {
  json j{{"name", c.column.name()}, {"trees", c.trees}, {"histogram", c.histogram}};
  for (const auto& [key, member] : column_numbers) j[key] = number(c.*member);
  return j;
}

/// Nothing where it is another column.
std::optional<ColumnSummary> to_summary(const json& j, const StatisticColumn& column) {
  if (j.at("name") != column.name()) return std::nullopt;
  ColumnSummary c{column};
  j.at("trees").get_to(c.trees);
  j.at("histogram").get_to(c.histogram);
  for (const auto& [key, member] : column_numbers) c.*member = number(j.at(key));
  return c;
}

json to_json(const CellResult& cell) {
  json columns = json::array(), orders = json::array();
  for (const auto& column : cell.columns) columns.push_back(to_json(column));
  for (const auto& order : cell.orders)
    orders.push_back({to_json(order.nodes), to_json(order.streams), to_json(order.nodes_pooled_ratio),
                      to_json(order.streams_pooled_ratio)});
  return {{"model", cell.model},
          {"n", cell.n},
          {"replicates", cell.replicates},
          {"columns", columns},
          {"orders", orders}};
}

/// Nothing where it holds other columns than these.
std::optional<CellResult> to_cell(const json& j, const std::vector<StatisticColumn>& columns) {
  CellResult cell;
  const json& stored = j.at("columns");
  if (stored.size() != columns.size()) return std::nullopt;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    auto summary = to_summary(stored.at(i), columns[i]);
    if (!summary) return std::nullopt;
    cell.columns.push_back(std::move(*summary));
  }
  j.at("model").get_to(cell.model);
  j.at("n").get_to(cell.n);
  j.at("replicates").get_to(cell.replicates);
  for (const auto& order : j.at("orders"))
    cell.orders.push_back({to_estimate(order.at(0)), to_estimate(order.at(1)), to_estimate(order.at(2)),
                           to_estimate(order.at(3))});
  return cell;
}

}  // namespace

std::filesystem::path CellStore::file_of(std::size_t index) const {
  const Cell& cell = plan_->cells[index];
  std::string key = fmt::format("{} {} {} {}({}) {} {} {}", version, table_schema, plan_->seed,
                                cell.model.name(), cell.model.stream_cell(cell.n), cell.n, cell.replicates,
                                GraftRule(cell.model, plan_->method).describe(cell.n));
  for (const auto* info : plan_->statistics.chosen()) key += fmt::format(" {}", info->name);
  return folder_ / fmt::format("{:016x}.json", hash_text(key));
}

std::optional<CellResult> CellStore::load(std::size_t index) const {
  std::ifstream file(file_of(index));
  const json content = json::parse(file, nullptr, false);
  if (content.is_discarded()) return std::nullopt;
  try {
    const Cell& cell = plan_->cells[index];
    auto result = to_cell(content, plan_->statistics.columns(cell.model.largest_order(cell.n)));
    if (result) result->model = cell.model.text();
    return result;
  } catch (const json::exception&) {
    return std::nullopt;  // a damaged file is grown again
  }
}

void CellStore::save(std::size_t index, const CellResult& result) const {
  write_file_atomically(file_of(index), to_json(result).dump(1) + "\n");
}

}  // namespace ramify
