#pragma once

#include <vector>

#include "claim.hpp"

namespace ramify {

/// Parts H2.<first>, ...: ternary trees of p = 1/R, and of a p that depends on the node.
std::vector<ClaimPart> ternary_recipe_parts(std::size_t first);

/// Their stream ratios, order by order.
NamedPlot ternary_recipe_picture(const Cancellation& cancellation);

}  // namespace ramify
