#include "ramify/fit/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "ramify/accumulate/real_summary.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {
namespace {

using nlohmann::json;

/// Replicates first, first + 1, ... as the outcome of an item.
Bytes encode(const Refits& refits) {
  return json::to_cbor(refits);
}

void take(const Bytes& outcome, std::uint64_t first, Refits& all) {
  auto refits = json::from_cbor(outcome).get<Refits>();
  std::ranges::move(refits, all.begin() + static_cast<std::ptrdiff_t>(first));
}

std::string identity_of(const Model& model, const BootstrapPlan& plan, std::span<const Size> sizes) {
  return fmt::format("bootstrap: {} trees of {} at n = {}, seed {}", plan.trees, model.text(),
                     fmt::join(sizes, ", "), plan.seed);
}

/// Of an item of shared work.
std::uint64_t trees_at_once(double nodes) {
  constexpr double in_memory = 1 << 20, most = 16;
  return static_cast<std::uint64_t>(std::clamp(in_memory / nodes, 1.0, most));
}

}  // namespace

Refits refitted_trees(const Model& model, std::span<const Size> sizes, double nodes,
                      const BootstrapPlan& plan, const Workforce& workforce, const Cancellation& cancellation,
                      const std::function<std::vector<double>(std::span<const RecordedTree* const>)>& fit) {
  const std::uint64_t chunk = trees_at_once(nodes);
  const auto refits_of = [&](std::size_t item) {
    const std::uint64_t first = item * chunk, last = std::min(first + chunk, plan.trees);
    std::vector<std::vector<RecordedTree>> grown;
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      const TreeBatch batch{model, sizes[s], plan.seed, 1, false};
      grown.push_back(batch.grown(s * plan.trees + first, s * plan.trees + last, cancellation));
    }
    Refits refits;
    for (std::size_t i = 0; i < last - first; ++i) {
      if (cancellation.requested()) throw Interrupted();
      std::vector<const RecordedTree*> trees;
      for (const auto& of_size : grown) trees.push_back(&of_size[i]);
      refits.push_back(fit(trees));
    }
    return refits;
  };
  SharedWork work{identity_of(model, plan, sizes),
                  std::vector<std::size_t>((plan.trees + chunk - 1) / chunk),
                  {},
                  {},
                  {}};
  std::iota(work.items.begin(), work.items.end(), std::size_t{0});
  Refits all(workforce.leads() ? plan.trees : 0);
  work.keep = [&](std::size_t item, unsigned) {
    std::ranges::move(refits_of(item), all.begin() + static_cast<std::ptrdiff_t>(item * chunk));
  };
  work.send = [&](std::size_t item, unsigned) { return encode(refits_of(item)); };
  work.take = [&](std::size_t item, const Bytes& outcome) { take(outcome, item * chunk, all); };
  share(work, workforce, cancellation);
  return all;
}

Refits refitted_counts(const Model& model, Size n, const BootstrapPlan& plan, const Workforce& workforce,
                       const Cancellation& cancellation,
                       const std::function<std::vector<double>(const ObservedCounts&)>& fit) {
  const GrowingJob job{model, n, plan.seed, {orders_and_height, true}, 0, plan.trees, 64};
  const auto refits_of = [&fit](const BlockTrees& trees) {
    Refits refits;
    trees.each([&](std::uint64_t, const TreeMeasures& measures) {
      const auto top = measures.streams.begin() + measures.strahler + 1;
      refits.push_back(fit(ObservedCounts{{measures.streams.begin(), top}}));
    });
    return refits;
  };
  Refits all(workforce.leads() ? plan.trees : 0);
  SharedBlockWork work;
  work.identity = identity_of(model, plan, {&n, 1});
  work.keep = [&](const Block& block, const BlockTrees& trees) {
    std::ranges::move(refits_of(trees), all.begin() + static_cast<std::ptrdiff_t>(block.first));
  };
  work.send = [&](const Block&, const BlockTrees& trees) { return encode(refits_of(trees)); };
  work.take = [&](const Block& block, const Bytes& outcome) { take(outcome, block.first, all); };
  grow_blocks({job}, workforce, cancellation, work);
  return all;
}

std::vector<double> with_misfit(std::vector<double> estimates, double misfit) {
  estimates.push_back(misfit);
  return estimates;
}

std::vector<double> take_misfits(Refits& refits, const BootstrapPlan& plan, FamilyFit& fit) {
  const std::size_t failed = std::erase_if(refits, [](const auto& refit) { return refit.empty(); });
  note_failures(failed, plan, fit);
  if (refits.empty()) return {};
  std::vector<double> misfits{fit.goodness.statistic};
  for (auto& refit : refits) {
    misfits.push_back(refit.back());
    refit.pop_back();
  }
  fit.goodness.trees = refits.size();
  return misfits;
}

std::vector<double> only_numbers(const Refits& refits) {
  std::vector<double> numbers;
  for (const auto& refit : refits) numbers.push_back(refit.front());
  return numbers;
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
