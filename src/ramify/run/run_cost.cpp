#include "ramify/run/run_cost.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/large/finite_means.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {
namespace {

/// What the exact means of a plan's cells take, and which of them no law gives in time.
struct LawsOfPlan {
  double seconds = 0;
  std::string left_out;
};

LawsOfPlan laws_of(const Plan& plan) {
  std::map<std::string, std::pair<const Model*, std::vector<Size>>> by_model;
  for (const Cell& cell : plan.cells) {
    if (!cell.model.is_split()) continue;
    auto& [model, sizes] = by_model[cell.model.text()];
    model = &cell.model;
    sizes.push_back(cell.n);
  }
  LawsOfPlan laws;
  for (const auto& [name, of] : by_model) {
    const FiniteMeansCost cost = FiniteMeans::cost(*of.first, of.second, plan.statistics);
    laws.seconds += cost.seconds;
    if (!cost.left_out.empty())
      laws.left_out +=
          fmt::format("  no exact_mean for {} of {} beyond n = {}: its laws would take too long\n",
                      fmt::join(cost.left_out, ", "), name, law_limit(*of.first));
  }
  return laws;
}

}  // namespace

std::string describe_cost(const std::vector<RunConfig>& configs, unsigned threads) {
  std::string text;
  WorkEstimate total{0, 0, 0};
  double law_seconds = 0;
  for (const auto& config : configs) {
    const Plan plan = make_plan(config);
    const WorkEstimate work = estimate_work(plan, threads);
    const LawsOfPlan laws = laws_of(plan);
    text += fmt::format(
        "{}: {} cells, {:.3g} nodes, about {:.1f} minutes on {} threads, {:.0f} MB; exact laws {:.0f} s of "
        "one thread\n",
        config.path, plan.cells.size(), work.nodes, work.minutes, threads, work.megabytes, laws.seconds);
    text += laws.left_out;
    total = {total.nodes + work.nodes, total.minutes + work.minutes,
             std::max(total.megabytes, work.megabytes)};
    law_seconds += laws.seconds;
  }
  return text +
         fmt::format(
             "in all {:.3g} nodes, about {:.1f} minutes, {:.0f} MB; exact laws {:.0f} s of one thread\n",
             total.nodes, total.minutes, total.megabytes, law_seconds);
}

void require_run_memory(const std::vector<RunConfig>& configs, unsigned threads) {
  for (const auto& config : configs) {
    const double bytes = 1e6 * estimate_work(make_plan(config), threads).megabytes;
    if (const double there = usable_memory(); bytes > there)
      throw Error(fmt::format("{}: it would take about {} of memory", config.path, in_bytes(bytes)),
                  fmt::format("this process may use {}", in_bytes(there)),
                  "take smaller n, fewer replicates or --threads 1; --dry-run says what is needed");
  }
}

double total_nodes(const std::vector<RunConfig>& configs) {
  double nodes = 0;
  for (const auto& config : configs) nodes += estimate_work(make_plan(config), 1).nodes;
  return nodes;
}

}  // namespace ramify
