#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ramify/io/table.hpp"
#include "ramify/page/page.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// A plot and what its files are.
struct FiledPlot {
  NamedPlot named;
  PlotFiles files;
};

/// Writes the plots into a folder (write_plot).
std::vector<FiledPlot> file_plots(std::vector<NamedPlot> plots, const std::filesystem::path& folder);

/// Why pictures are missing of plots that have something to draw: the reason of the first; empty where none
/// is.
std::string why_missing(const std::vector<FiledPlot>& plots);

/// The plot as a page shows it: its SVG with the title below, and with axes, subtitle, series and their
/// ranges as the alternative text; where it was not drawn, a paragraph that names it as missing, and why.
PageBlock figure_of(const FiledPlot& filed);

/// What the plots show, as numbers: a row for every place of every series, "point" (with the half length of
/// its error bar), "curve" or "guide", with as many digits as read back the same.
Table points_table(const std::vector<FiledPlot>& plots);

}  // namespace ramify
