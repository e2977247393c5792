#include "ramify/statistic/tree_indices.hpp"

namespace ramify {

std::span<const StatisticInfo> tree_indices() {
  return {};
}

}  // namespace ramify
