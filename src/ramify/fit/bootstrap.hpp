#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// A parametric bootstrap: so many trees of a fitted model, replicates 0.. of its stream.
struct BootstrapPlan {
  std::uint64_t trees;
  std::uint64_t seed;
};

/// Grows every replicate: a tree of each of several sizes, and hands them over, replicates on any thread and
/// in any order. Replicate r of size s (from 0) is replicate s B + r of `ramify sample` at the plan's seed.
/// Throws Interrupted. Cost: some 40 ns a node.
/// @param nodes  of a replicate, about: so many replicates lie in memory together as have 2^24
/// @param fit    fit(replicate, trees)
void each_replicate(const Model& model, std::span<const Size> sizes, double nodes, const BootstrapPlan& plan,
                    unsigned threads, const Cancellation& cancellation,
                    const std::function<void(std::uint64_t, std::span<const RecordedTree* const>)>& fit);

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
