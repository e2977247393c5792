#pragma once

#include <vector>

#include "claim.hpp"

namespace ramify {

/// Parts C17.5 to C17.8: F <= S <= B in every tree, and what of it tries and PATRICIA trees share.
std::vector<ClaimPart> sandwich_parts();

}  // namespace ramify
