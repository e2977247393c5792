#include "ramify/run/run_cost.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/run/plan.hpp"

namespace ramify {

std::string describe_cost(const std::vector<RunConfig>& configs, unsigned threads) {
  std::string text;
  WorkEstimate total{0, 0, 0};
  for (const auto& config : configs) {
    const Plan plan = make_plan(config);
    const WorkEstimate work = estimate_work(plan, threads);
    text += fmt::format("{}: {} cells, {:.3g} nodes, about {:.1f} minutes on {} threads, {:.0f} MB\n",
                        config.path, plan.cells.size(), work.nodes, work.minutes, threads, work.megabytes);
    total = {total.nodes + work.nodes, total.minutes + work.minutes,
             std::max(total.megabytes, work.megabytes)};
  }
  return text + fmt::format("in all {:.3g} nodes, about {:.1f} minutes, {:.0f} MB\n", total.nodes,
                            total.minutes, total.megabytes);
}

double total_nodes(const std::vector<RunConfig>& configs) {
  double nodes = 0;
  for (const auto& config : configs) nodes += estimate_work(make_plan(config), 1).nodes;
  return nodes;
}

}  // namespace ramify
