#include "ramify/fit/tree_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/fit/nested_test.hpp"
#include "ramify/fit/tree_bootstrap.hpp"

namespace ramify {
namespace {

/// Nodes that divide in more ways than one.
std::size_t choices_needed(const Family& family) {
  return std::max<std::size_t>(1, family.parameters.size());
}

void require_enough(const Family& family, const ObservedSplits& splits, const std::string& where) {
  if (are_enough(splits, family)) return;
  throw Error(
      fmt::format("{}: {:g} internal nodes, {:g} of which divide in more ways than one", where,
                  splits.nodes(), splits.choices()),
      fmt::format("{} needs {} of them: trees of {} internal nodes are the smallest that can be fitted",
                  family.name, choices_needed(family), smallest_tree(family)),
      "take a larger tree, or several pooled");
}

TreeFit fit_of(std::string name, const ObservedSplits& splits, std::span<const Family* const> families,
               const TreeFitOptions& options, const Cancellation& cancellation) {
  TreeFit fit{std::move(name), splits.nodes(), {}};
  for (const Family* family : families) require_enough(*family, splits, fit.name);
  for (const Family* family : families) {
    if (cancellation.requested()) throw Interrupted();
    FamilyFit& one =
        fit.families.emplace_back(fit_family(*family, tree_objective(*family, splits), splits.nodes()));
    if (options.bootstrap.trees > 0 && one.converged)
      bootstrap_tree_fit(one, splits, options.bootstrap, options.workforce, cancellation);
  }
  if (options.bootstrap.trees > 0)
    for (const NestedPair& pair : nested_pairs(fit.families))
      add_nested_test(pair, grown_ratios(pair, splits, options.bootstrap, options.workforce, cancellation));
  rank(fit.families);
  return fit;
}

}  // namespace

Size smallest_tree(const Family& family) {
  return ObservedSplits::smallest_size - 1 + choices_needed(family);
}

bool are_enough(const ObservedSplits& splits, const Family& family) {
  return splits.choices() >= static_cast<double>(choices_needed(family));
}

Objective tree_objective(const Family& family, const ObservedSplits& splits) {
  SearchBox box = search_box(family);
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    if (family.parameters[i].scale.kind == SearchScale::Kind::plain || family.parameters.size() > 1) continue;
    box.low[i] -= std::log(10);
    box.high[i] += std::log(10);
  }
  return {family.of_splits(splits), std::move(box.low), std::move(box.high)};
}

std::vector<TreeFit> fit_trees(std::span<const RecordedTree> trees, std::span<const Family* const> families,
                               const TreeFitOptions& options, const Cancellation& cancellation) {
  return fits_of_trees<ObservedSplits>(
      trees, options.pooled, [&](std::string name, const ObservedSplits& splits) {
        return fit_of(std::move(name), splits, families, options, cancellation);
      });
}

}  // namespace ramify
