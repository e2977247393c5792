#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ramify/fit/family_fit.hpp"

namespace ramify {

/// A family without parameters that a larger one holds, and what the tree says of it.
struct NestedPair {
  const FamilyFit* simpler;
  FamilyFit* larger;
  Point place;  ///< where the larger family is the simpler one, as searched
};

/// The pairs among fits of one observation in which the simpler family is nested in the larger
/// (Family::nested), both fitted. Of other families a likelihood ratio has no null distribution: none.
std::vector<NestedPair> nested_pairs(std::vector<FamilyFit>& fits);

/// 2 (log L of the larger - log L of the simpler); 0 where rounding leaves less.
double likelihood_ratio(const NestedPair& pair);

/// 2 (the function at the place - its minimum): the likelihood ratio of a tree that was grown, both
/// likelihoods from one function, so that what this errs by cancels.
/// @param minus_log_likelihood  of the larger family
double likelihood_ratio(const Family& larger, const Objective& minus_log_likelihood, const Point& place);

/// Adds to the larger fit whether the simpler family suffices: the p-value is (1 + trees whose ratio is at
/// least the observed) / (trees + 1).
/// @param grown  likelihood ratios of trees of the simpler family, fitted with both like the observation
void add_nested_test(const NestedPair& pair, std::span<const double> grown);

}  // namespace ramify
