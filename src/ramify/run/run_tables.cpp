#include "ramify/run/run_tables.hpp"

#include <algorithm>
#include <cmath>

namespace ramify {
namespace {

Row row_head(const CheckedCell& cell, std::uint64_t trees) {
  Row row;
  row.whole(cell.number).text(cell.result.model).whole(cell.result.n).whole(trees);
  return row;
}

}  // namespace

std::optional<double> CheckedCell::worst_z() const {
  std::optional<double> worst;
  for (const auto& check : checks)
    if (check) worst = std::max(worst.value_or(0), std::fabs(check->z));
  return worst;
}

Table summary_table(const std::vector<CheckedCell>& cells) {
  Table table({"cell", "model", "n", "replicates", "statistic", "mean", "standard_error", "variance", "min",
               "q05", "q50", "q95", "max", "exact_mean", "z"});
  for (const auto& cell : cells) {
    for (std::size_t i = 0; i < cell.result.columns.size(); ++i) {
      const auto& c = cell.result.columns[i];
      auto row = row_head(cell, c.trees);
      row.text(c.column.name());
      for (const double value : {c.mean, c.standard_error, c.variance, c.min, c.q05, c.q50, c.q95, c.max})
        row.summary(value);
      if (const auto& check = cell.checks[i])
        row.summary(check->exact_mean).fixed(check->z, 3);
      else
        row.nothing().nothing();
      table.add(std::move(row));
    }
  }
  return table;
}

Table orders_table(const std::vector<CheckedCell>& cells) {
  Table table({"cell", "model", "n", "replicates", "leaf_order", "order", "mean_nodes", "mean_nodes_error",
               "mean_streams", "mean_streams_error", "nodes_pooled_ratio", "nodes_pooled_ratio_error",
               "streams_pooled_ratio", "streams_pooled_ratio_error"});
  for (const auto& cell : cells) {
    for (std::size_t k = 0; k < cell.result.orders.size(); ++k) {
      const auto& order = cell.result.orders[k];
      auto row = row_head(cell, cell.result.replicates);
      row.whole(0).whole(k);
      for (const auto& estimate :
           {order.nodes, order.streams, order.nodes_pooled_ratio, order.streams_pooled_ratio})
        row.summary(estimate.value).summary(estimate.standard_error);
      table.add(std::move(row));
    }
  }
  return table;
}

Table histograms_table(const std::vector<CheckedCell>& cells) {
  Table table({"cell", "model", "n", "replicates", "statistic", "value", "trees"});
  for (const auto& cell : cells) {
    for (const auto& column : cell.result.columns) {
      for (const auto& [value, trees] : column.histogram) {
        table.add(row_head(cell, column.trees).text(column.column.name()).whole(value).whole(trees));
      }
    }
  }
  return table;
}

}  // namespace ramify
