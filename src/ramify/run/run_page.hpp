#pragma once

#include <cstddef>
#include <vector>

#include "ramify/config/run_config.hpp"
#include "ramify/page/page.hpp"
#include "ramify/report/filed_plot.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_tables.hpp"

namespace ramify {

/// What a finished run has found, for reading: its cells and how their trees were sampled, its pictures, its
/// tables beside the exact laws, and what it is made from. Where, when and on how many threads stand in
/// provenance.json alone: the page is the same bytes everywhere, but for what gnuplot makes of the pictures.
/// @param plan  of the config
Page run_page(const RunConfig& config, const Plan& plan, const CheckedRun& run,
              const std::vector<FiledPlot>& plots);

/// Rows of a table that a page shows: what is longer is cut, and the page says so.
inline constexpr std::size_t most_shown_rows = 1000;

}  // namespace ramify
