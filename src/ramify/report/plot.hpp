#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// A point and the half length of its error bar; 0 or NaN draws none.
struct PlotPoint {
  double x;
  double y;
  double error = 0;
};

/// What is known of one thing, a model say: points that were measured, a curve that was computed, a dashed
/// line that is claimed or fitted. All have one colour and one entry in the legend (none where the label is
/// empty); lines lie beneath points.
struct PlotSeries {
  enum class Mark { symbol, bar };

  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::string label;
  std::vector<PlotPoint> points = {};
  std::vector<PlotPoint> curve = {};  ///< broken where a point has no place
  std::vector<PlotPoint> guide = {};
  Mark mark = Mark::symbol;  ///< of the points; bars stand on 0
  double bar_width = 1;
  /// Colour and symbol, by number; by default the series' place in the plot. One number for one model in all
  /// plots.
  std::optional<std::size_t> look = {};
  // NOLINTEND(readability-redundant-member-init)
};

/// A picture of a table: x against y, series by series.
struct Plot {
  std::string title;
  std::string subtitle;  ///< the estimator, the convention, the number of trees
  std::string x_label;
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<PlotSeries> series = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
  bool whole_x = false;                 ///< tics at whole numbers alone
};

/// A plot and the name of its files.
struct NamedPlot {
  std::string stem;
  Plot plot;
};

/// What became of a plot.
enum class PlotStatus {
  drawn,       ///< script, SVG and PNG are there
  no_points,   ///< nothing to draw: no file was written
  no_gnuplot,  ///< gnuplot is not installed: the script alone
  failed,      ///< gnuplot refused or was stopped: the script alone, message says why
};

struct PlotFiles {
  PlotStatus status = PlotStatus::drawn;
  std::string message;  ///< what gnuplot said when it failed
  std::filesystem::path script, svg, png;
};

/// Writes stem.gp and has gnuplot draw stem.svg and stem.png (1000 by 640) from it; `gnuplot stem.gp` in that
/// folder draws them again.
///
/// The script holds the data and is the same bytes for the same plot; so are the pictures, by one gnuplot
/// with the same fonts. Points that are not finite, or not positive on a log axis, are left out. Throws Error
/// only where the script cannot be written.
PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder, std::string_view stem);

/// Why there is no picture, "gnuplot is not installed"; empty where there is one.
std::string why_not_drawn(const PlotFiles& files);

}  // namespace ramify
