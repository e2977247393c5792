#pragma once

#include <cstdint>
#include <vector>

#include "ramify/fit/family_fit.hpp"

namespace ramify {

/// A parametric bootstrap: so many trees of a fitted model, replicates 0.. of its stream.
struct BootstrapPlan {
  std::uint64_t trees;
  std::uint64_t seed;
};

/// Quantiles, bias and deviation of the estimates of the grown trees, into the fit.
/// @param estimates  of every tree the parameters
void summarise_bootstrap(const std::vector<std::vector<double>>& estimates, FamilyFit& fit);

}  // namespace ramify
