#pragma once

#include <vector>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// Every known constant of a model, in the order of `ramify theory`: depth, height, strahler, fill_level,
/// split_mean, split_variance. One that does not exist, or is not known in closed form, is left out.
std::vector<Constant> constants(const Model& model);

}  // namespace ramify
