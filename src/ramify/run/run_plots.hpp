#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ramify/report/plot.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_tables.hpp"

namespace ramify {

/// One plot for each statistic with a single column: its mean against n, a line for each model. None where no
/// model has two sizes.
/// @param plan  of the cells
std::vector<std::pair<std::string, Plot>> run_plots(const std::vector<CheckedCell>& cells, const Plan& plan);

}  // namespace ramify
