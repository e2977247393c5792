#include "ramify/fit/tree_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/fit/lack_of_fit.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {
namespace {

/// Grown at once: they lie in memory together.
std::uint64_t trees_at_once(Size n, unsigned threads) {
  constexpr Size nodes = Size{1} << 24;
  return std::clamp<std::uint64_t>(nodes / n, threads, 256);
}

/// Splits of replicates first..last-1, each of trees of all the sizes observed.
std::vector<ObservedSplits> grown_splits(const Model& model, const ObservedSplits& observed,
                                         const BootstrapPlan& plan, unsigned threads, std::uint64_t first,
                                         std::uint64_t last, const Cancellation& cancellation) {
  std::vector<ObservedSplits> splits(last - first);
  std::uint64_t offset = 0;
  for (const Size n : observed.tree_sizes()) {
    const TreeBatch batch{model, n, plan.seed, threads, false};
    const auto trees = batch.grown(offset + first, offset + last, cancellation);
    for (std::size_t i = 0; i < trees.size(); ++i)
      splits[i].add(ObservedSplits(trees[i].tree, trees[i].name));
    offset += plan.trees;
  }
  return splits;
}

/// look(replicate, its splits) of the trees of a bootstrap; several threads call it at once.
template <class Look>
void each_grown_tree(const Model& model, const ObservedSplits& observed, const BootstrapPlan& plan,
                     unsigned threads, const Cancellation& cancellation, Look look) {
  const std::uint64_t chunk = trees_at_once(static_cast<Size>(observed.nodes()), threads);
  for (std::uint64_t first = 0; first < plan.trees; first += chunk) {
    const std::uint64_t last = std::min(first + chunk, plan.trees);
    const auto splits = grown_splits(model, observed, plan, threads, first, last, cancellation);
    parallel_for(splits.size(), threads, [&](std::size_t i, unsigned) {
      if (cancellation.requested()) throw Interrupted();
      look(first + i, splits[i]);
    });
  }
}

/// The fit of a replicate: from where the observed fit lies, and from between where a pair may be exchanged.
/// Nothing where it does not converge.
std::optional<FittedFeatures> refitted(const Family& family, const ObservedSplits& splits, Point at) {
  const Objective objective = tree_objective(family, splits);
  for (std::size_t i = 0; i < at.size(); ++i)  // back and forth between scales rounds
    at[i] = std::clamp(at[i], objective.low[i], objective.high[i]);
  if (at.empty()) return FittedFeatures{{}, features_of(splits, -objective.value({}))};
  std::vector<Point> starts{at};
  if (family.mirror == Mirror::exchanged) {
    const double middle = (at[0] + at[1]) / 2;
    starts.push_back({middle, middle});
  }
  const Minimum best = minima(objective, starts).front();
  if (!best.converged) return {};
  return FittedFeatures{folded(family, best.at), features_of(splits, -best.value)};
}

/// The first is the observed one.
double p_value(const std::vector<double>& lacks, std::uint64_t seed) {
  std::uint64_t more = 0, equal = 0;
  for (std::size_t i = 1; i < lacks.size(); ++i) {
    const double off = lacks[i] - lacks[0], rounding = 1e-9 * (1 + lacks[0]);
    if (off > rounding) ++more;
    if (std::abs(off) <= rounding) ++equal;
  }
  Stream stream({seed, 0}, 0, Lane::walk);
  return static_cast<double>(1 + more + uniform_below(stream, equal + 1)) / static_cast<double>(lacks.size());
}

}  // namespace

void bootstrap_tree_fit(FamilyFit& fit, const ObservedSplits& observed, const BootstrapPlan& plan,
                        unsigned threads, const Cancellation& cancellation) {
  const Family& family = *fit.family;
  const std::vector<double> estimates = fit.estimates();
  const Model model = family.at(estimates);
  const Point at = family.searched(estimates);
  std::vector<std::optional<FittedFeatures>> refits(plan.trees);
  each_grown_tree(model, observed, plan, threads, cancellation,
                  [&](std::uint64_t replicate, const ObservedSplits& splits) {
                    refits[replicate] = refitted(family, splits, at);
                  });
  std::vector<FittedFeatures> all{{at, features_of(observed, fit.log_likelihood)}};
  std::vector<std::vector<double>> grown;
  for (auto& refit : refits) {
    if (!refit) continue;
    grown.push_back(family.values(refit->searched));
    all.push_back(std::move(*refit));
  }
  if (const std::uint64_t failed = plan.trees - grown.size(); failed > 0)
    add_note(fit.note, fmt::format("{} of {} bootstrap trees could not be fitted", failed, plan.trees));
  if (grown.empty()) return;
  summarise_bootstrap(grown, fit);
  const std::vector<double> lacks = lack_of_fit(all);
  fit.goodness = {lacks[0], p_value(lacks, plan.seed), grown.size(), 0};
}

std::vector<double> grown_ratios(const NestedPair& pair, const ObservedSplits& observed,
                                 const BootstrapPlan& plan, unsigned threads,
                                 const Cancellation& cancellation) {
  std::vector<double> ratios(plan.trees);
  each_grown_tree(pair.simpler->family->at({}), observed, plan, threads, cancellation,
                  [&](std::uint64_t replicate, const ObservedSplits& splits) {
                    const Family& larger = *pair.larger->family;
                    ratios[replicate] = likelihood_ratio(larger, tree_objective(larger, splits), pair.place);
                  });
  return ratios;
}

}  // namespace ramify
