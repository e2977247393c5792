#pragma once

#include <vector>

#include "claim.hpp"

namespace ramify {

/// Parts C6.<first>, ...: 1/mu takes every value in [1/log 2, infinity).
std::vector<ClaimPart> depth_range_parts(std::size_t first);

}  // namespace ramify
