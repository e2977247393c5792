#pragma once

#include <filesystem>
#include <vector>

#include "ramify/report/plot.hpp"
#include "ramify/run/run_tables.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// One plot for each statistic with a single column: its mean against n, a line for each model. None where no
/// model has two sizes.
std::vector<std::pair<std::string, Plot>> run_plots(const std::vector<CheckedCell>& cells,
                                                    const StatisticSet& statistics);

}  // namespace ramify
