#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/family/observed_splits.hpp"
#include "ramify/fit/bootstrap.hpp"
#include "ramify/fit/nested_test.hpp"

namespace ramify {

/// Parametric bootstrap of a fit to whole trees: trees of the fitted model at the sizes observed, each fitted
/// as those were, into fit.bootstrap and fit.goodness.
///
/// Replicate r of tree t (from 0) is replicate t B + r of `ramify sample` of the fitted model at this size
/// and seed; the result is the same whatever the threads. Trees whose fit does not converge are left out, and
/// counted in the note. The statistic of goodness is lack_of_fit(); its p-value is (1 + number of trees that
/// lack more) / (B + 1), and among equals the place is drawn. Throws Interrupted.
/// Cost, a tree: growing, some 40 ns a node, and a fit without intervals.
void bootstrap_tree_fit(FamilyFit& fit, const ObservedSplits& observed, const BootstrapPlan& plan,
                        const Workforce& workforce, const Cancellation& cancellation);

/// Likelihood ratios of trees of a simpler family, those of its bootstrap, fitted with both families: what
/// add_nested_test() takes; none in a process that only helps. Throws Interrupted. Cost: as of a bootstrap.
std::vector<double> grown_ratios(const NestedPair& pair, const ObservedSplits& observed,
                                 const BootstrapPlan& plan, const Workforce& workforce,
                                 const Cancellation& cancellation);

}  // namespace ramify
