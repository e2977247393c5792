#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/fit/count_likelihood.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// A parametric bootstrap: so many trees of a fitted model, replicates 0.. of its stream.
struct BootstrapPlan {
  std::uint64_t trees;
  std::uint64_t seed;
};

/// What became of the replicates of a bootstrap, each a list of numbers; an empty one where it could not be
/// fitted.
using Refits = std::vector<std::vector<double>>;

/// Grows every replicate, a tree of each of several sizes, and fits it, by any thread of any process.
/// Replicate r of size s (from 0) is replicate s B + r of `ramify sample` at the plan's seed. Throws
/// Interrupted. Cost: some 40 ns a node.
/// @param nodes  of a replicate, about: a thread holds so many as have 2^20, 16 at most
/// @param fit    fit(trees), called by several threads at once
/// @return what `fit` made of each; nothing at all in a process that only helps
Refits refitted_trees(const Model& model, std::span<const Size> sizes, double nodes,
                      const BootstrapPlan& plan, const Workforce& workforce, const Cancellation& cancellation,
                      const std::function<std::vector<double>(std::span<const RecordedTree* const>)>& fit);

/// The same of stream counts alone, without the trees: replicate r is that of `ramify sample` (grafted).
/// Cost: some 3 ns a node.
Refits refitted_counts(const Model& model, Size n, const BootstrapPlan& plan, const Workforce& workforce,
                       const Cancellation& cancellation,
                       const std::function<std::vector<double>(const ObservedCounts&)>& fit);

/// A refit that is estimates and, last, how far off it is.
std::vector<double> with_misfit(std::vector<double> estimates, double misfit);

/// Leaves the estimates of those that could be fitted; how many could is noted in the fit.
/// @return the fit's own misfit, then theirs; nothing where none could
std::vector<double> take_misfits(Refits& refits, const BootstrapPlan& plan, FamilyFit& fit);

/// Of refits that are one number each, these.
std::vector<double> only_numbers(const Refits& refits);

/// P(a larger one): (1 + how many of the trees have a larger statistic) / (trees + 1); among equals the place
/// is drawn, so that every p-value is as likely as any other where the model is right.
/// @param statistics  of the observation, then of the trees
double bootstrap_p_value(const std::vector<double>& statistics, std::uint64_t seed);

/// Says in the fit's note how many trees could not be fitted, if any.
void note_failures(std::uint64_t failed, const BootstrapPlan& plan, FamilyFit& fit);

/// Quantiles, bias and deviation of the estimates of the grown trees, into the fit.
/// @param estimates  of every tree the parameters
void summarise_bootstrap(const std::vector<std::vector<double>>& estimates, FamilyFit& fit);

}  // namespace ramify
