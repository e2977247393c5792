#pragma once

#include <vector>

#include "ramify/io/table.hpp"
#include "ramify/optimise/scanned_curve.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// From 1.45 to 100.
const std::vector<double>& map_depths();

/// Which heights go with a depth: depth, lowest_height and the model that has it, highest_height and the
/// model that has it, symmetric_height of the beta(a,a) of this depth. Where the model is split(x) its height
/// is a limit, which no beta tree reaches.
///
/// Throws Error for a depth that no beta tree has, Interrupted.
Table height_map(const std::vector<double>& depths, const ScanEffort& effort);

/// The same as a picture: height over depth against depth.
Plot height_map_plot(const Table& map);

}  // namespace ramify
