#include "ramify/measure/norms_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ramify/law/exact_means.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// n of a tree of nodes with two children; 0 of any other.
Size binary_size(const TreeMeasurement& tree) {
  if (!tree.measures) return 0;
  const TreeMeasures& m = *tree.measures;
  Size forks = 0;
  for (std::size_t k = 1; k <= m.strahler; ++k) forks += m.bi_orders.nodes(k);
  return forks == m.size && m.streams[0] == m.size + 1 ? m.size : 0;
}

/// Of the tree, not of a node drawn from it, and not of n alone.
std::vector<StatisticColumn> normed() {
  std::vector<StatisticColumn> columns;
  for (const StatisticInfo& info : statistics()) {
    const Recurrence& recurrence = info.law.recurrence;
    if (info.shape == Columns::one && known_of(recurrence) >= Known::moments &&
        !std::holds_alternative<WeightedWalk>(recurrence))
      columns.emplace_back(info);
  }
  return columns;
}

/// The indices that the literature scales.
bool is_scaled(const StatisticColumn& column) {
  return column == statistic::sackin || column == statistic::colless;
}

void add_norms(Row& row, const std::optional<Moments>& moments, double value, double normalised) {
  const double deviation = moments ? std::sqrt(moments->variance) : none;
  const double mean = moments ? moments->mean : none;
  row.summary(mean).summary(deviation);
  row.summary(deviation > 0 ? (value - mean) / deviation : none).summary(normalised);
}

}  // namespace

Table norms_table(const std::vector<TreeMeasurement>& trees) {
  Table table({"tree", "n", "statistic", "value", "yule_mean", "yule_deviation", "yule_z", "yule_normalised",
               "uniform_mean", "uniform_deviation", "uniform_z", "uniform_normalised"});
  Size largest = 0;
  for (const auto& tree : trees) largest = std::max(largest, binary_size(tree));
  const ExactMeans yule(Model::parse("bst"), largest), uniform(Model::parse("catalan"), largest);
  for (const auto& tree : trees) {
    const Size n = binary_size(tree);
    if (n == 0) continue;
    const double leaves = static_cast<double>(n) + 1;
    for (const StatisticColumn& column : normed()) {
      const double value = column.real_value(*tree.measures);
      const auto of_yule = yule.moments(column, n), of_uniform = uniform.moments(column, n);
      Row row;
      row.text(tree.orders.name).whole(n).text(column.name()).summary(value);
      add_norms(row, of_yule, value, is_scaled(column) && of_yule ? (value - of_yule->mean) / leaves : none);
      add_norms(row, of_uniform, value, is_scaled(column) ? value / std::pow(leaves, 1.5) : none);
      table.add(std::move(row));
    }
  }
  return table;
}

}  // namespace ramify
