#include "ramify/run/run_tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/number.hpp"
#include "ramify/io/csv_writer.hpp"

namespace ramify {
namespace {

std::vector<std::string> head(const CheckedCell& cell, std::uint64_t trees) {
  return {std::to_string(cell.number), cell.result.model, std::to_string(cell.result.n),
          std::to_string(trees)};
}

void append(std::vector<std::string>& row, const Estimate& estimate) {
  row.push_back(format_summary(estimate.value));
  row.push_back(format_summary(estimate.standard_error));
}

}  // namespace

std::optional<double> CheckedCell::worst_z() const {
  std::optional<double> worst;
  for (const auto& check : checks)
    if (check) worst = std::max(worst.value_or(0), std::fabs(check->z));
  return worst;
}

std::string summary_table(const std::vector<CheckedCell>& cells) {
  CsvTable table({"cell", "model", "n", "replicates", "statistic", "mean", "standard_error", "variance",
                  "min", "q05", "q50", "q95", "max", "exact_mean", "z"});
  for (const auto& cell : cells) {
    for (std::size_t i = 0; i < cell.result.columns.size(); ++i) {
      const auto& c = cell.result.columns[i];
      auto row = head(cell, c.trees);
      row.push_back(c.name);
      for (const double value : {c.mean, c.standard_error, c.variance, c.min, c.q05, c.q50, c.q95, c.max})
        row.push_back(format_summary(value));
      const auto& check = cell.checks[i];
      row.push_back(check ? format_summary(check->exact_mean) : "");
      row.push_back(check ? fmt::format("{:.3f}", check->z) : "");
      table.add(std::move(row));
    }
  }
  return table.text();
}

std::string orders_table(const std::vector<CheckedCell>& cells) {
  CsvTable table({"cell", "model", "n", "replicates", "leaf_order", "order", "mean_nodes", "mean_nodes_error",
                  "mean_streams", "mean_streams_error", "nodes_pooled_ratio", "nodes_pooled_ratio_error",
                  "streams_pooled_ratio", "streams_pooled_ratio_error"});
  for (const auto& cell : cells) {
    for (std::size_t k = 0; k < cell.result.orders.size(); ++k) {
      const auto& order = cell.result.orders[k];
      auto row = head(cell, cell.result.replicates);
      row.emplace_back("0");
      row.emplace_back(std::to_string(k));
      for (const auto& estimate :
           {order.nodes, order.streams, order.nodes_pooled_ratio, order.streams_pooled_ratio})
        append(row, estimate);
      table.add(std::move(row));
    }
  }
  return table.text();
}

std::string histograms_table(const std::vector<CheckedCell>& cells) {
  CsvTable table({"cell", "model", "n", "replicates", "statistic", "value", "trees"});
  for (const auto& cell : cells) {
    for (const auto& column : cell.result.columns) {
      for (const auto& [value, trees] : column.histogram) {
        auto row = head(cell, column.trees);
        row.insert(row.end(), {column.name, std::to_string(value), std::to_string(trees)});
        table.add(std::move(row));
      }
    }
  }
  return table.text();
}

}  // namespace ramify
