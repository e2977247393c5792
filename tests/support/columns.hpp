#pragma once

#include <string_view>

#include "ramify/statistic/statistic_info.hpp"

namespace ramify::test {

/// The column of that name, of orders up to 9: "strahler", "nodes_3". Throws std::invalid_argument.
StatisticColumn column(std::string_view name);

}  // namespace ramify::test
