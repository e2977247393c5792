#pragma once

#include <string>
#include <vector>

#include "ramify/config/run_config.hpp"

namespace ramify {

/// Nodes, minutes, memory and the seconds of exact laws of configs and of all together, a line each; and a
/// line for each model with statistics whose laws take too long.
std::string describe_cost(const std::vector<RunConfig>& configs, unsigned threads);

/// Throws Error where one of the configs needs more memory than there is.
void require_run_memory(const std::vector<RunConfig>& configs, unsigned threads);

/// Nodes to grow in all.
double total_nodes(const std::vector<RunConfig>& configs);

}  // namespace ramify
