#pragma once

#include <vector>

#include "claim.hpp"

namespace ramify {

/// Parts C22.3 to C22.8: the constant and the fluctuation of E S_n, counts of nodes and streams, ramification
/// matrix and Tokunaga numbers of equiprobable binary trees.
std::vector<ClaimPart> catalan_fluctuation_parts();
std::vector<ClaimPart> catalan_count_parts();

}  // namespace ramify
