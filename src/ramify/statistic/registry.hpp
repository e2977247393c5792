#pragma once

#include <functional>
#include <vector>

#include "ramify/statistic/statistic_info.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {

/// All statistics, in the order they are listed.
const std::vector<std::reference_wrapper<const StatisticInfo>>& statistics();

/// Those that code refers to.
namespace statistic {
extern const StatisticInfo &strahler, &height, &depth, &width, &fill_level, &balance, &cherries, &sackin,
    &colless, &nodes, &streams, &nodes_mean_ratio, &streams_mean_ratio;
}  // namespace statistic

}  // namespace ramify
