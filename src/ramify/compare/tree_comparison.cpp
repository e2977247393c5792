#include "ramify/compare/tree_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "ramify/accumulate/real_summary.hpp"
#include "ramify/compare/holm.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/sample/measure_tree.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

/// Each has one column.
StatisticSet compared() {
  return StatisticSet({&statistic::strahler, &statistic::height, &statistic::width, &statistic::fill_level,
                       &statistic::balance, &statistic::cherries, &statistic::sackin, &statistic::colless,
                       &statistic::nodes_mean_ratio, &statistic::streams_mean_ratio});
}

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

Row values_of(const std::vector<StatisticColumn>& columns, const TreeMeasures& measures) {
  Row values;
  for (const StatisticColumn& column : columns) values.push_back(column.real_value(measures));
  return values;
}

/// Of a block: the trees are few.
constexpr std::uint64_t most_trees = 16;

/// The statistics of simulated trees, tree by tree.
std::vector<Row> simulated(const Model& model, Size n, const std::vector<StatisticColumn>& columns,
                           const Simulation& simulation, const Cancellation& cancellation) {
  require_memory("the simulated trees", "--replicates", simulation.trees, [&](std::uint64_t trees) {
    return static_cast<double>(trees) * static_cast<double>(sizeof(Row) + 16 + 8 * columns.size());
  });
  std::vector<Row> rows(simulation.trees);
  const GrowingJob job{model,     n, simulation.seed, whole_trees(all_but_indices), 0, simulation.trees,
                       most_trees};
  grow_blocks({job}, simulation.threads, cancellation, [&](const Block&, const BlockTrees& trees) {
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      rows[replicate] = values_of(columns, measures);
    });
  });
  return rows;
}

double two_sided(double at_most, double at_least) {
  return std::min(1.0, 2 * std::min(at_most, at_least));
}

/// Below it a tail of an exact law is not known: laws of orders and heights are cut at 1e-20, others are
/// right to 1e-15.
double least_p_value(const StatisticInfo& statistic) {
  return &statistic == &statistic::strahler || &statistic == &statistic::height ? 1e-20 : 1e-15;
}

double exact_p_value(const FiniteLaw& law, double observed) {
  double at_most = 0, at_least = 0, value = law.first;
  for (const double p : law.probabilities) {
    if (value <= observed) at_most += p;
    if (value >= observed) at_least += p;
    ++value;
  }
  return two_sided(at_most, at_least);
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
  RealSummary summary;
  for (const Row& row : rows) summary.add(row[column]);
  return {summary.mean(), summary.variance()};
}

}  // namespace

/// What trees of the model have at one size.
struct TreeComparison::Reference {
  std::vector<StatisticColumn> columns;
  std::optional<ExactMeans> exact;  ///< none of a model that is grown whole
  std::vector<Row> trees;           ///< simulated

  Reference(const Model& model, Size n, const Simulation& simulation, const Cancellation& cancellation)
      : columns(compared().columns(model.largest_order(n))),
        trees(simulated(model, n, columns, simulation, cancellation)) {
    if (model.is_split()) exact.emplace(model, n);
  }

  ComparedStatistic compare(std::size_t i, Size n, double observed) const {
    const auto known = exact ? exact->moments(columns[i], n) : std::nullopt;
    const bool has_moments = known && !std::isnan(known->variance);
    const Moments moments = has_moments ? *known : simulated_moments(trees, i);
    const auto law = exact ? exact->law(columns[i], n) : std::nullopt;
    const double least =
        law ? least_p_value(*columns[i].statistic) : 2 / (static_cast<double>(trees.size()) + 1);
    const double p = law ? exact_p_value(*law, observed) : simulated_p_value(trees, i, observed);
    return {columns[i],         observed, moments.mean,    std::sqrt(std::max(0.0, moments.variance)),
            std::max(p, least), 0,        law.has_value(), p <= least};
  }
};

double ComparedStatistic::effect() const {
  const double off = observed - expected;
  if (deviation > 0) return off / deviation;
  return std::abs(off) < 1e-9 * std::abs(expected)
             ? 0
             : std::copysign(std::numeric_limits<double>::infinity(), off);
}

TreeComparison::TreeComparison(Model model, const Simulation& simulation, const Cancellation& cancellation)
    : model_(std::move(model)), simulation_(simulation), cancellation_(cancellation) {}

TreeComparison::~TreeComparison() = default;

const TreeComparison::Reference& TreeComparison::reference(Size n) {
  auto& kept = references_[n];
  if (!kept) kept = std::make_unique<const Reference>(model_, n, simulation_, cancellation_);
  return *kept;
}

std::vector<ComparedStatistic> TreeComparison::operator()(const Tree& tree, std::string_view where) {
  require_comparable(tree, model_, where);
  const Size n = tree.size();
  model_.require_size(n);
  const Reference& trees = reference(n);
  const Row observed =
      values_of(trees.columns, measure_tree(tree, {simulation_.seed, 0}, 0, all_but_indices));
  std::vector<ComparedStatistic> result;
  std::vector<double> p_values;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (std::isnan(observed[i])) continue;  // a statistic that says nothing of this tree
    result.push_back(trees.compare(i, n, observed[i]));
    p_values.push_back(result.back().p_value);
  }
  const auto adjusted = holm_adjusted(p_values);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].adjusted_p = adjusted[i];
  return result;
}

}  // namespace ramify
