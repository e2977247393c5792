#include "ramify/report/filed_plot.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ramify {
namespace {

/// "from 100 to 1e+09"
std::string range_of(const std::vector<PlotPoint>& points, double PlotPoint::* coordinate) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const PlotPoint& point : points)
    if (const double value = point.*coordinate; std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return low == high ? fmt::format("at {:.4g}", low) : fmt::format("from {:.4g} to {:.4g}", low, high);
}

/// "bst: 14 points, x from 300 to 5.8e+08, y from 4.1 to 17.2, and a curve"
std::string series_words(const PlotSeries& series) {
  std::vector<std::string> parts;
  if (!series.points.empty())
    parts.push_back(
        fmt::format("{} {}", series.points.size(), series.points.size() == 1 ? "point" : "points"));
  if (!series.curve.empty()) parts.emplace_back("a curve");
  if (!series.guide.empty()) parts.emplace_back("a dashed line");
  if (parts.empty()) return "";
  const auto& shown = !series.points.empty()  ? series.points
                      : !series.curve.empty() ? series.curve
                                              : series.guide;
  return fmt::format("{}{}, x {}, y {}", series.label.empty() ? "" : series.label + ": ",
                     fmt::join(parts, " and "), range_of(shown, &PlotPoint::x),
                     range_of(shown, &PlotPoint::y));
}

std::string plot_words(const Plot& plot) {
  std::vector<std::string> series;
  for (const PlotSeries& one : plot.series)
    if (std::string words = series_words(one); !words.empty()) series.push_back(std::move(words));
  return fmt::format("Plot of {}{} against {}{}{}. {}.", plot.y_label, plot.log_y ? ", logarithmic" : "",
                     plot.x_label, plot.log_x ? ", logarithmic" : "",
                     plot.subtitle.empty() ? "" : fmt::format(" ({})", plot.subtitle),
                     fmt::join(series, "; "));
}

std::string svg_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void add_points(Table& table, const NamedPlot& plot, const PlotSeries& series, std::string_view kind,
                const std::vector<PlotPoint>& points) {
  for (const PlotPoint& point : points) {
    Row row;
    row.texts({plot.stem, series.label, kind}).exact(point.x).exact(point.y);
    if (point.error > 0)
      row.exact(point.error);
    else
      row.nothing();
    table.add(std::move(row));
  }
}

}  // namespace

std::vector<FiledPlot> file_plots(std::vector<NamedPlot> plots, const std::filesystem::path& folder) {
  std::vector<FiledPlot> filed;
  for (NamedPlot& plot : plots) {
    PlotFiles files = write_plot(plot.plot, folder, plot.stem);
    filed.push_back({std::move(plot), std::move(files)});
  }
  return filed;
}

std::string why_missing(const std::vector<FiledPlot>& plots) {
  for (const FiledPlot& plot : plots)
    if (plot.files.status != PlotStatus::no_points)
      if (std::string why = why_not_drawn(plot.files); !why.empty()) return why;
  return "";
}

PageBlock figure_of(const FiledPlot& filed) {
  const auto& [stem, plot] = filed.named;
  if (const std::string why = why_not_drawn(filed.files); !why.empty())
    return PageParagraph{fmt::format("Picture missing ({}): {}.", plot.title, why)};
  return PagePicture{svg_in(filed.files.svg), plot_words(plot), plot.title};
}

Table points_table(const std::vector<FiledPlot>& plots) {
  Table table({"picture", "series", "kind", "x", "y", "error"});
  for (const FiledPlot& filed : plots)
    for (const PlotSeries& series : filed.named.plot.series) {
      add_points(table, filed.named, series, "point", series.points);
      add_points(table, filed.named, series, "curve", series.curve);
      add_points(table, filed.named, series, "guide", series.guide);
    }
  return table;
}

}  // namespace ramify
