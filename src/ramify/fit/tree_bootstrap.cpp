#include "ramify/fit/tree_bootstrap.hpp"

#include <algorithm>
#include <optional>

#include "ramify/fit/lack_of_fit.hpp"
#include "ramify/fit/tree_fit.hpp"

namespace ramify {
namespace {

/// look(replicate, its splits) of the trees of a bootstrap; several threads call it at once.
template <class Look>
void each_grown_tree(const Model& model, const ObservedSplits& observed, const BootstrapPlan& plan,
                     unsigned threads, const Cancellation& cancellation, Look look) {
  each_replicate(model, observed.tree_sizes(), observed.nodes(), plan, threads, cancellation,
                 [&](std::uint64_t replicate, std::span<const RecordedTree* const> trees) {
                   ObservedSplits splits;
                   for (const RecordedTree* tree : trees) splits.add(ObservedSplits(tree->tree, tree->name));
                   look(replicate, splits);
                 });
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
  note_failures(plan.trees - grown.size(), plan, fit);
  if (grown.empty()) return;
  summarise_bootstrap(grown, fit);
  const std::vector<double> lacks = lack_of_fit(all);
  fit.goodness = {lacks[0], bootstrap_p_value(lacks, plan.seed), grown.size(), 0};
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
