#include "ramify/fit/tree_bootstrap.hpp"

#include <algorithm>
#include <iterator>

#include "ramify/fit/lack_of_fit.hpp"
#include "ramify/fit/tree_fit.hpp"

namespace ramify {
namespace {

/// look(its splits) of the trees of a bootstrap; several threads call it at once.
template <class Look>
Refits look_at_grown(const Model& model, const ObservedSplits& observed, const BootstrapPlan& plan,
                     const Workforce& workforce, const Cancellation& cancellation, Look look) {
  return refitted_trees(model, observed.tree_sizes(), observed.nodes(), plan, workforce, cancellation,
                        [&look](std::span<const RecordedTree* const> trees) {
                          ObservedSplits splits;
                          for (const RecordedTree* tree : trees)
                            splits.add(ObservedSplits(tree->tree, tree->name));
                          return look(splits);
                        });
}

/// The fit of a replicate: from where the observed fit lies, and from between where a pair may be exchanged.
/// The estimates as searched, then the features; nothing where it does not converge.
std::vector<double> refitted(const Family& family, const ObservedSplits& splits, Point at) {
  const Objective objective = tree_objective(family, splits);
  for (std::size_t i = 0; i < at.size(); ++i)  // back and forth between scales rounds
    at[i] = std::clamp(at[i], objective.low[i], objective.high[i]);
  if (at.empty()) return features_of(splits, -objective.value({}));
  std::vector<Point> starts{at};
  if (family.mirror == Mirror::exchanged) {
    const double middle = (at[0] + at[1]) / 2;
    starts.push_back({middle, middle});
  }
  const Minimum best = minima(objective, starts).front();
  if (!best.converged) return {};
  std::vector<double> numbers = folded(family, best.at);
  std::ranges::copy(features_of(splits, -best.value), std::back_inserter(numbers));
  return numbers;
}

}  // namespace

void bootstrap_tree_fit(FamilyFit& fit, const ObservedSplits& observed, const BootstrapPlan& plan,
                        const Workforce& workforce, const Cancellation& cancellation) {
  const Family& family = *fit.family;
  const std::vector<double> estimates = fit.estimates();
  const Model model = family.at(estimates);
  const Point at = family.searched(estimates);
  const Refits refits =
      look_at_grown(model, observed, plan, workforce, cancellation,
                    [&](const ObservedSplits& splits) { return refitted(family, splits, at); });
  std::vector<FittedFeatures> all{{at, features_of(observed, fit.log_likelihood)}};
  std::vector<std::vector<double>> grown;
  for (const auto& refit : refits) {
    if (refit.empty()) continue;
    const auto features = refit.begin() + static_cast<std::ptrdiff_t>(at.size());
    all.push_back({{refit.begin(), features}, {features, refit.end()}});
    grown.push_back(family.values(all.back().searched));
  }
  note_failures(refits.size() - grown.size(), plan, fit);
  if (grown.empty()) return;
  summarise_bootstrap(grown, fit);
  const std::vector<double> lacks = lack_of_fit(all);
  fit.goodness = {lacks[0], bootstrap_p_value(lacks, plan.seed), grown.size(), 0};
}

std::vector<double> grown_ratios(const NestedPair& pair, const ObservedSplits& observed,
                                 const BootstrapPlan& plan, const Workforce& workforce,
                                 const Cancellation& cancellation) {
  const Family& larger = *pair.larger->family;
  return only_numbers(look_at_grown(pair.simpler->family->at({}), observed, plan, workforce, cancellation,
                                    [&](const ObservedSplits& splits) {
                                      return std::vector{likelihood_ratio(
                                          larger, tree_objective(larger, splits), pair.place)};
                                    }));
}

}  // namespace ramify
