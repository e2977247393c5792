#include "ramify/fit/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/accumulate/real_summary.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {

namespace {

std::uint64_t trees_at_once(double nodes, unsigned threads) {
  constexpr double in_memory = 1 << 24, most = 256;
  return std::max<std::uint64_t>(threads, static_cast<std::uint64_t>(std::min(in_memory / nodes, most)));
}

}  // namespace

void each_replicate(const Model& model, std::span<const Size> sizes, double nodes, const BootstrapPlan& plan,
                    unsigned threads, const Cancellation& cancellation,
                    const std::function<void(std::uint64_t, std::span<const RecordedTree* const>)>& fit) {
  const std::uint64_t chunk = trees_at_once(nodes, threads);
  for (std::uint64_t first = 0; first < plan.trees; first += chunk) {
    const std::uint64_t last = std::min(first + chunk, plan.trees);
    std::vector<std::vector<RecordedTree>> grown;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      const TreeBatch batch{model, sizes[s], plan.seed, threads, false};
      grown.push_back(batch.grown(s * plan.trees + first, s * plan.trees + last, cancellation));
    }
    parallel_for(last - first, threads, [&](std::size_t i, unsigned) {
      if (cancellation.requested()) throw Interrupted();
      std::vector<const RecordedTree*> trees;
      for (const auto& of_size : grown) trees.push_back(&of_size[i]);
      fit(first + i, trees);
    });
  }
}

double bootstrap_p_value(const std::vector<double>& statistics, std::uint64_t seed) {
  std::uint64_t more = 0, equal = 0;
  for (std::size_t i = 1; i < statistics.size(); ++i) {
    const double off = statistics[i] - statistics[0], rounding = 1e-9 * (1 + statistics[0]);
    if (off > rounding) ++more;
    if (std::abs(off) <= rounding) ++equal;
  }
  Stream stream({seed, 0}, 0, Lane::walk);
  return static_cast<double>(1 + more + uniform_below(stream, equal + 1)) /
         static_cast<double>(statistics.size());
}

void note_failures(std::uint64_t failed, const BootstrapPlan& plan, FamilyFit& fit) {
  if (failed > 0)
    add_note(fit.note, fmt::format("{} of {} bootstrap trees could not be fitted", failed, plan.trees));
}

void summarise_bootstrap(const std::vector<std::vector<double>>& estimates, FamilyFit& fit) {
  fit.bootstrap.clear();
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    RealSummary summary;
    for (const auto& tree : estimates) summary.add(tree[i]);
    const auto band = summary.interpolated_quantiles({0.025, 0.975});
    fit.bootstrap.push_back(
        {band[0], band[1], summary.mean() - fit.parameters[i].estimate, std::sqrt(summary.variance())});
  }
}

}  // namespace ramify
