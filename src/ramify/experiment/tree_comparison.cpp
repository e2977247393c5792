#include "ramify/experiment/tree_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "ramify/compare/holm.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/law/balance_law.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/law/fill_level_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/law/strahler_law.hpp"
#include "ramify/sample/measure_tree.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

const std::vector<std::string> compared{
    "strahler", "height", "width",   "fill_level",       "balance",
    "cherries", "sackin", "colless", "nodes_mean_ratio", "streams_mean_ratio"};

void require_comparable(const Tree& tree, const Model& model, std::string_view where) {
  if (tree.size() < 2)
    throw Error(fmt::format("{}: n = {}", where, tree.size()),
                "all trees of fewer than two internal nodes are alike", "take a larger tree");
  if (!model.counts_internal_nodes())
    throw Error(fmt::format("{}: model {}", where, model.text()), "its n does not count internal nodes",
                "take a model that does; see: ramify list models");
  const auto arities = tree.arities();
  const bool binary =
      std::all_of(arities.begin(), arities.end(), [](std::uint32_t a) { return a == 0 || a == 2; });
  if (model.is_split() && !binary)
    throw Error(fmt::format("{}: a node with other than two children", where),
                fmt::format("trees of {} are binary", model.text()),
                "contract one-child nodes, resolve forks of three");
}

using Row = std::vector<double>;

Row values_of(const std::vector<StatisticSet::Column>& columns, const TreeMeasures& measures) {
  std::vector<StatisticValue> row;
  write_statistics(columns, measures, row);
  Row values;
  for (std::size_t i = 0; i < columns.size(); ++i)
    values.push_back(columns[i].statistic->real ? row[i].real : static_cast<double>(row[i].whole));
  return values;
}

/// The statistics of simulated trees, tree by tree.
std::vector<Row> simulate(const Model& model, Size n, const std::vector<StatisticSet::Column>& columns,
                          const Simulation& simulation, const Cancellation& cancellation) {
  const auto prototype = make_tree_sampler({model, grow_all, n, &cancellation});
  const StreamKey key{simulation.seed, model.stream_cell(n)};
  std::vector<std::unique_ptr<TreeSampler>> samplers(simulation.threads);
  std::vector<Row> rows(simulation.trees);
  parallel_for(rows.size(), simulation.threads, [&](std::size_t replicate, unsigned worker) {
    if (cancellation.requested()) throw Interrupted();
    if (!samplers[worker]) samplers[worker] = prototype->clone();
    TreeMeasures measures;
    samplers[worker]->sample(n, key, replicate, measures);
    rows[replicate] = values_of(columns, measures);
  });
  return rows;
}

double two_sided(double at_most, double at_least) {
  return std::min(1.0, 2 * std::min(at_most, at_least));
}

/// From the law of a statistic; nothing where it has none, or the tree is too large for it.
std::optional<double> exact_p_value(const std::string& name, const Model& model, Size n, double observed,
                                    const Cancellation& cancellation) {
  if (!model.is_split() || n > law_limit(model)) return std::nullopt;
  const auto from = [&](const auto& law) {
    double at_most = 0, at_least = 0, value = static_cast<double>(law.lowest(n));
    for (const double p : law.pmf(n)) {
      if (value <= observed) at_most += p;
      if (value >= observed) at_least += p;
      ++value;
    }
    return two_sided(at_most, at_least);
  };
  if (name == "strahler") return from(build_law(model, n, StrahlerLaw(n), cancellation));
  if (name == "height") return from(build_law(model, n, HeightLaw(), cancellation));
  if (name == "fill_level") return from(build_law(model, n, FillLevelLaw(n), cancellation));
  if (name == "balance") return from(build_law(model, n, BalanceLaw(n), cancellation));
  return std::nullopt;
}

/// The tree itself counts as one of the simulated ones, so no p-value is 0.
double simulated_p_value(const std::vector<Row>& rows, std::size_t column, double observed) {
  double at_most = 1, at_least = 1;
  for (const Row& row : rows) {
    if (row[column] <= observed) ++at_most;
    if (row[column] >= observed) ++at_least;
  }
  const double count = static_cast<double>(rows.size()) + 1;
  return two_sided(at_most / count, at_least / count);
}

Moments simulated_moments(const std::vector<Row>& rows, std::size_t column) {
  double mean = 0, squares = 0;
  for (const Row& row : rows) mean += row[column] / static_cast<double>(rows.size());
  for (const Row& row : rows) squares += (row[column] - mean) * (row[column] - mean);
  return {mean, squares / static_cast<double>(rows.size() - 1)};
}

}  // namespace

double ComparedStatistic::effect() const {
  const double off = observed - expected;
  if (deviation > 0) return off / deviation;
  return std::abs(off) < 1e-9 * std::abs(expected)
             ? 0
             : std::copysign(std::numeric_limits<double>::infinity(), off);
}

std::vector<ComparedStatistic> compare_tree(const Tree& tree, const Model& model,
                                            const Simulation& simulation, std::string_view where,
                                            const Cancellation& cancellation) {
  require_comparable(tree, model, where);
  const Size n = tree.size();
  model.require_size(n);
  const auto columns = StatisticSet::parse(compared).columns(model.largest_order(n));
  const Row observed = values_of(columns, measure_tree(tree, {simulation.seed, 0}, 0));
  const auto rows = simulate(model, n, columns, simulation, cancellation);
  std::optional<ExactMeans> exact;
  if (model.is_split()) exact.emplace(model, n);
  std::vector<ComparedStatistic> result;
  std::vector<double> p_values;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto known = exact ? exact->moments(columns[i].name, n) : std::nullopt;
    const bool has_moments = known && !std::isnan(known->variance);
    const Moments moments = has_moments ? *known : simulated_moments(rows, i);
    const auto p = exact_p_value(columns[i].name, model, n, observed[i], cancellation);
    p_values.push_back(p ? *p : simulated_p_value(rows, i, observed[i]));
    result.push_back({columns[i].name, observed[i], moments.mean, std::sqrt(std::max(0.0, moments.variance)),
                      p_values.back(), 0, p.has_value()});
  }
  const auto adjusted = holm_adjusted(p_values);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].adjusted_p = adjusted[i];
  return result;
}

}  // namespace ramify
