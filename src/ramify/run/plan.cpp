#include "ramify/run/plan.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

/// Levels that stay open while a tree of this model grows, from the rough growth of its height.
double open_levels(const Cell& cell) {
  if (!cell.model.is_split()) return cell.model.grown().expected_nodes(cell.n);  // stored whole
  const double n = static_cast<double>(cell.n);
  const SplitFraction fraction = cell.model.character().fraction;
  if (const double e = depth_exponent(fraction); e > 0) return std::min(n, 6 * std::pow(n, e));
  const auto* constant = std::get_if<ConstantFraction>(&fraction);
  const double smallest_share = constant != nullptr ? std::min(constant->p, 1 - constant->p) : 0.1;
  return std::min(n, std::log(n + 1) / -std::log1p(-smallest_share) + 50);
}

}  // namespace

Plan make_plan(const RunConfig& config) {
  Plan plan{config.seed, config.statistics, sampling_method(config.statistics, config.graft), {}};
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      for (const Size n : group.sizes) plan.cells.push_back({model, n, group.replicates.count(n)});
  return plan;
}

WorkEstimate estimate_work(const Plan& plan, unsigned threads) {
  constexpr double nanoseconds_a_node = 25, nanoseconds_grafted = 60, open_node_bytes = 28,
                   table_bytes = 140e3, value_bytes = 64;
  WorkEstimate work{0, 0, 20};
  for (const auto& cell : plan.cells) {
    const double trees = static_cast<double>(cell.replicates);
    const GraftRule rule(cell.model, plan.method);
    const double nodes = trees * rule.grown_nodes(cell.n);
    work.nodes += nodes;
    work.minutes +=
        nodes * (rule.size(cell.n) > 0 ? nanoseconds_grafted : nanoseconds_a_node) / 1e9 / 60 / threads;
    const double columns =
        static_cast<double>(plan.statistics.columns(cell.model.largest_order(cell.n)).size());
    const double bytes =
        open_levels(cell) * open_node_bytes * threads + table_bytes + trees * columns * value_bytes;
    work.megabytes = std::max(work.megabytes, 20 + bytes / 1e6);
  }
  return work;
}

}  // namespace ramify
