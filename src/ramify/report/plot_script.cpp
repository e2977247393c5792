#include "ramify/report/plot_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/number.hpp"
#include "ramify/report/plot_axis.hpp"

namespace ramify::detail {
namespace {

using Style = PlotSeries::Style;

constexpr int width = 1000, height = 640;
constexpr int left = 98, right = 28, bottom = 70;
constexpr int title_height = 44, subtitle_height = 24, legend_row_height = 21;

// Okabe and Ito's colours, told apart by colour-blind readers and in grey; yellow is too pale on white.
constexpr std::array<std::string_view, 7> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#E69F00", "#56B4E9", "#444444"};
// Filled circle, square, triangle, diamond, triangle down, pentagon, open circle.
constexpr std::array<int, 7> shapes{7, 5, 9, 13, 11, 15, 6};
constexpr std::array<double, 7> shape_sizes{1.0, 0.85, 1.1, 1.15, 1.1, 1.0, 1.0};

/// Characters, not bytes.
std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool has_line(Style style) {
  return style != Style::points;
}
bool has_points(Style style) {
  return style == Style::points || style == Style::points_line;
}

/// The look of a series, as gnuplot options.
std::string look(const PlotSeries& series, std::size_t place) {
  const std::size_t color = series.color.value_or(place) % palette.size();
  std::string options = fmt::format("lc rgb '{}'", palette[color]);
  options += has_line(series.style) ? " lw 2" : " lw 1.5";
  if (series.style == Style::dashed) options += " dt (9,6)";
  if (has_points(series.style)) options += fmt::format(" pt {} ps {}", shapes[color], shape_sizes[color]);
  return options;
}

class Script {
 public:
  Script(const Plot& plot, std::string_view stem)
      : plot_(plot), stem_(stem), x_(plot.log_x), y_(plot.log_y), blocks_(plot.series.size()) {
    for (std::size_t i = 0; i < plot.series.size(); ++i)
      for (const auto& point : plot.series[i].points) add_point(point, blocks_[i]);
    for (const auto& series : plot.series)
      if (!series.label.empty()) longest_label_ = std::max(longest_label_, length(series.label));
    legend_entries_ = static_cast<std::size_t>(std::count_if(
        plot.series.begin(), plot.series.end(), [](const auto& series) { return !series.label.empty(); }));
  }

  std::optional<std::string> text() {
    if (std::all_of(blocks_.begin(), blocks_.end(), [](const auto& block) { return block.empty(); }))
      return std::nullopt;
    x_.pad(0.03);
    y_.pad(0.06);
    return head() + data() + frame() + titles() + legend() + drawing();
  }

 private:
  /// One line of data: x, y, and both ends of the error bar.
  void add_point(const PlotPoint& point, std::string& block) {
    if (!x_.holds(point.x) || !y_.holds(point.y)) return;
    const double error = std::isfinite(point.error) ? std::abs(point.error) : 0;
    // On a log axis a bar that reaches 0 has no lower end: it is cut where it leaves the picture.
    const double low = y_.holds(point.y - error) ? point.y - error : point.y / 10;
    for (const double y : {point.y, low, point.y + error}) y_.include(y);
    x_.include(point.x);
    block += fmt::format("{} {} {} {}\n", format_summary(point.x), format_summary(point.y),
                         format_summary(low), format_summary(point.y + error));
  }

  std::size_t legend_columns() const {
    const std::size_t entry = 62 + 10 * longest_label_;  // as wide as gnuplot takes them to be
    return std::max<std::size_t>(1, static_cast<std::size_t>(width - left - right) / entry);
  }

  int top() const {
    const auto rows = static_cast<int>((legend_entries_ + legend_columns() - 1) / legend_columns());
    return 8 + title_height + (plot_.subtitle.empty() ? 0 : subtitle_height) + (rows > 0 ? 14 : 8) +
           rows * legend_row_height;
  }

  static double across(int pixels) { return static_cast<double>(pixels) / width; }
  static double down(int pixels) { return 1 - static_cast<double>(pixels) / height; }

  std::string head() const {
    return fmt::format(
        "# Draws {0}.svg and {0}.png:  gnuplot {0}.gp\n"
        "# One of them:  gnuplot -e \"formats='svg'\" {0}.gp\n"
        "if (!exists('formats')) formats = 'svg png'\n"
        "set encoding utf8\n\n",
        stem_);
  }

  std::string data() const {
    std::string text = "# x, y, lower and upper end of the error bar\n";
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      if (!blocks_[i].empty()) text += fmt::format("$series_{} << END\n{}END\n", i + 1, blocks_[i]);
    return text + "\n";
  }

  std::string frame() const {
    return fmt::format(
               "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n"
               "set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
               across(left), across(width - right), down(height - bottom), down(top())) +
           "set border 3 lc rgb '#555555' lw 1\n"
           "set tics nomirror out scale 0.6,0.3 textcolor rgb '#333333'\n"
           "set grid xtics ytics lt 1 lw 1 lc rgb '#E6E6E6'\n"
           "set errorbars small\n" +
           x_.script("x") + y_.script("y");
  }

  std::string titles() const {
    std::string text =
        fmt::format("set label 1 {} at screen {:.4f},{:.4f} left font ',22' textcolor rgb '#111111'\n",
                    gnuplot_string(plot_.title), across(left), down(36));
    if (!plot_.subtitle.empty())
      text += fmt::format("set label 2 {} at screen {:.4f},{:.4f} left font ',15' textcolor rgb '#555555'\n",
                          gnuplot_string(plot_.subtitle), across(left), down(62));
    // Labels at places in the picture: gnuplot's own depend on its guess of the font, and leave the SVG.
    return text +
           fmt::format(
               "set label 3 {} at screen {:.4f},{:.4f} center font ',16' textcolor rgb '#333333'\n"
               "set label 4 {} at screen {:.4f},{:.4f} center rotate font ',16' textcolor rgb '#333333'\n",
               gnuplot_string(plot_.x_label), across((left + width - right) / 2), down(height - 20),
               gnuplot_string(plot_.y_label), across(20), down((top() + height - bottom) / 2));
  }

  std::string legend() const {
    if (legend_entries_ == 0) return "unset key\n\n";
    return fmt::format(
        "set key at screen {:.4f},{:.4f} left bottom horizontal Left reverse samplen 2.5 maxcols {} "
        "font ',15' textcolor rgb '#333333'\n\n",
        across(left - 10), down(top() - 14), legend_columns());
  }

  /// Lines under points, whatever the order of the legend.
  std::vector<std::string> layers() const {
    std::vector<std::string> lines, points, entries;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const PlotSeries& series = plot_.series[i];
      if (blocks_[i].empty()) continue;
      const std::string options = look(series, i);
      const std::string block = fmt::format("$series_{}", i + 1);
      if (has_line(series.style))
        lines.push_back(fmt::format("{} using 1:2 with lines {} notitle", block, options));
      if (has_points(series.style))
        points.push_back(fmt::format("{} using 1:2:3:4 with yerrorbars {} notitle", block, options));
      if (series.label.empty()) continue;
      const std::string_view sample = !has_points(series.style) ? "lines"
                                      : has_line(series.style)  ? "linespoints"
                                                                : "points";
      entries.push_back(
          fmt::format("keyentry with {} {} title {}", sample, options, gnuplot_string(series.label)));
    }
    lines.insert(lines.end(), points.begin(), points.end());
    lines.insert(lines.end(), entries.begin(), entries.end());
    return lines;
  }

  std::string drawing() const {
    return fmt::format(
        "do for [f in formats] {{\n"
        "  if (f eq 'svg') {{\n"
        "    set terminal svg noenhanced size {0},{1} background rgb 'white' font 'sans-serif,14'\n"
        "  }} else {{\n"
        "    set terminal pngcairo noenhanced size {0},{1} background rgb 'white' fontscale 0.75 font "
        "'DejaVu Sans,14'\n"
        "  }}\n"
        "  set output {2}.f\n"
        "  plot {3}\n"
        "  unset output\n"
        "}}\n",
        width, height, gnuplot_string(fmt::format("{}.", stem_)), fmt::join(layers(), ", \\\n       "));
  }

  const Plot& plot_;
  std::string_view stem_;
  PlotAxis x_, y_;
  std::vector<std::string> blocks_;
  std::size_t longest_label_ = 0;
  std::size_t legend_entries_ = 0;
};

}  // namespace

std::string gnuplot_string(std::string_view text) {
  // gnuplot 5.4 misreads a string that starts with the escaped quote ('''), so there is none: it becomes an
  // apostrophe.
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'')
      quoted += "\u2019";
    else
      quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + "'";
}

std::optional<std::string> plot_script(const Plot& plot, std::string_view stem) {
  return Script(plot, stem).text();
}

}  // namespace ramify::detail
