#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "ramify/model/model.hpp"

namespace ramify {

/// All models, in the order they are listed.
const std::vector<std::reference_wrapper<const ModelInfo>>& models();

/// Throws Error for an unknown name, nearest names given.
const ModelInfo& find_model(std::string_view name);

}  // namespace ramify
