#pragma once

#include <span>

#include "ramify/statistic/statistic_info.hpp"

namespace ramify {

/// The rows of the registry that are indices of the shape of trees, most of them of phylogenetics.
std::span<const StatisticInfo> tree_indices();

}  // namespace ramify
