#include "ramify/run/plan.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/version.hpp"
#include "ramify/sample/graft_rule.hpp"
#include "ramify/sample/open_levels.hpp"

namespace ramify {
Plan make_plan(const RunConfig& config) {
  Plan plan{config.seed, config.statistics, sampling_method(config.statistics, config.graft), {}};
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      for (const Size n : group.sizes) plan.cells.push_back({model, n, group.replicates.count(n)});
  return plan;
}

std::vector<StatisticColumn> columns_of(const Plan& plan, const Cell& cell) {
  return plan.statistics.columns(cell.model.largest_order(cell.n));
}

std::vector<std::string> described(const Plan& plan) {
  std::vector<std::string> names;
  for (const auto* info : plan.statistics.chosen()) names.emplace_back(info->name);
  std::vector<std::string> lines{fmt::format("ramify {}, tables {}", version, table_schema),
                                 fmt::format("seed {}", plan.seed),
                                 fmt::format("statistics {}", fmt::join(names, ", "))};
  for (const Cell& cell : plan.cells)
    lines.push_back(fmt::format("{} at n = {}: {} trees, {}", cell.model.text(), cell.n, cell.replicates,
                                GraftRule(cell.model, plan.method).describe(cell.n)));
  return lines;
}

std::string identity_of(const Plan& plan) {
  return fmt::format("{}\n", fmt::join(described(plan), "\n"));
}

std::vector<GrowingJob> jobs_of(const Plan& plan) {
  std::vector<GrowingJob> jobs;
  for (const Cell& cell : plan.cells)
    jobs.push_back({cell.model, cell.n, plan.seed, plan.method, 0, cell.replicates});
  return jobs;
}

std::uint64_t total_trees(const Plan& plan) {
  std::uint64_t trees = 0;
  for (const Cell& cell : plan.cells) trees += cell.replicates;
  return trees;
}

WorkEstimate estimate_work(const Plan& plan, unsigned threads) {
  constexpr double nanoseconds_a_node = 25, nanoseconds_grafted = 60, table_bytes = 140e3, value_bytes = 64;
  WorkEstimate work{0, 0, 20};
  for (const auto& cell : plan.cells) {
    const double trees = static_cast<double>(cell.replicates);
    const GraftRule rule(cell.model, plan.method);
    const double nodes = trees * rule.grown_nodes(cell.n);
    work.nodes += nodes;
    work.minutes +=
        nodes * (rule.size(cell.n) > 0 ? nanoseconds_grafted : nanoseconds_a_node) / 1e9 / 60 / threads;
    const double columns = static_cast<double>(columns_of(plan, cell).size());
    const double bytes =
        growing_bytes(cell.model, cell.n, plan.method.pass) * std::min<double>(threads, trees) + table_bytes +
        trees * columns * value_bytes;
    work.megabytes = std::max(work.megabytes, 20 + bytes / 1e6);
  }
  return work;
}

}  // namespace ramify
