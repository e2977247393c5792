#pragma once

#include <string>
#include <vector>

#include "ramify/config/run_config.hpp"

namespace ramify {

/// Nodes, minutes and memory of configs and of all together, a line each.
std::string describe_cost(const std::vector<RunConfig>& configs, unsigned threads);

/// Nodes to grow in all.
double total_nodes(const std::vector<RunConfig>& configs);

}  // namespace ramify
