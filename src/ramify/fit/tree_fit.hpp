#pragma once

#include <span>
#include <string>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/fit/bootstrap.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Families fitted to one tree, or to several together.
struct TreeFit {
  std::string name;
  double nodes;                     ///< internal
  std::vector<FamilyFit> families;  ///< by ascending AIC
};

struct TreeFitOptions {
  /// One fit of all trees, whose likelihoods multiply, and not one of each.
  bool pooled = false;
  /// tree_bootstrap.hpp; none where it has no trees.
  BootstrapPlan bootstrap{0, 1996};
  Workforce workforce = 1;  ///< decides the time alone
};

/// Which model's tree is it? Every family fitted to whole trees by the exact likelihood of their splits,
/// where left and right mean nothing (SplitLikelihood), and ranked by AIC.
///
/// Standard errors and profile intervals are those of the likelihood (FamilyFit): nodes divide independently
/// of each other given the sizes, so they hold as n grows; how well they hold at this n is what the bootstrap
/// says. Throws Error for a tree that is not binary, and where a tree is too small for a family (the smallest
/// that can be fitted is said); throws Interrupted.
/// @param families  one at least
std::vector<TreeFit> fit_trees(std::span<const RecordedTree> trees, std::span<const Family* const> families,
                               const TreeFitOptions& options, const Cancellation& cancellation);

/// A fit of each tree, or one of all where they are pooled.
/// @tparam Observed  what a likelihood takes of a tree; made of (tree, name), added up
/// @param  fit       TreeFit fit(std::string name, const Observed&)
template <class Observed, class Fit>
std::vector<TreeFit> fits_of_trees(std::span<const RecordedTree> trees, bool pooled, Fit fit) {
  std::vector<TreeFit> fits;
  Observed all;
  for (const RecordedTree& tree : trees) {
    const Observed observed(tree.tree, tree.name);
    if (pooled)
      all.add(observed);
    else
      fits.push_back(fit(tree.name, observed));
  }
  if (!pooled || trees.empty()) return fits;
  const std::string more = trees.size() == 1 ? "" : " and " + std::to_string(trees.size() - 1) + " more";
  fits.push_back(fit(trees[0].name + more, all));
  return fits;
}

/// The smallest tree that a family is fitted to: 3 nodes for a parameter or none, 4 for two. Nodes of less
/// than 3 divide in one way alone.
Size smallest_tree(const Family& family);

/// Whether a family can be told from these splits at all: a choice for each parameter, and one at least.
bool are_enough(const ObservedSplits& splits, const Family& family);

/// Minus the log-likelihood of splits. Where one parameter is searched on a logarithmic scale, the box is ten
/// times wider at either end than search_box(family): the likelihood has no trouble there, and ends of
/// intervals are often near.
Objective tree_objective(const Family& family, const ObservedSplits& splits);

}  // namespace ramify
