#include "ramify/report/plot_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/number.hpp"
#include "ramify/core/utf8.hpp"
#include "ramify/report/plot_axis.hpp"

namespace ramify::detail {
namespace {

using Mark = PlotSeries::Mark;

constexpr int width = 1000, height = 640;
constexpr int left = 98, right = 28, bottom = 70;
constexpr int title_height = 44, subtitle_height = 24, legend_row_height = 21;

// Okabe and Ito's colours, told apart by colour-blind readers and in grey, and a wine red; yellow is too pale
// on white.
constexpr std::array<std::string_view, 8> palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#E69F00", "#56B4E9", "#444444", "#882255"};
// Filled circle, square, triangle, diamond, triangle down, pentagon, open circle, open square.
constexpr std::array<int, 8> shapes{7, 5, 9, 13, 11, 15, 6, 4};
constexpr std::array<double, 8> shape_sizes{1.0, 0.85, 1.1, 1.15, 1.1, 1.0, 1.0, 0.85};

/// Colour and symbol of a series; beyond the palette a colour comes again with another symbol.
class Look {
 public:
  explicit Look(std::size_t number)
      : color_(palette[number % palette.size()]),
        shape_((number + number / palette.size()) % shapes.size()) {}

  std::string symbol() const {
    return fmt::format("lc rgb '{}' lw 1.5 pt {} ps {}", color_, shapes[shape_], shape_sizes[shape_]);
  }
  std::string solid() const { return fmt::format("lc rgb '{}' lw 2", color_); }
  std::string dashed() const { return solid() + " dt (9,6)"; }
  std::string bar() const {
    return fmt::format("lc rgb '{0}' lw 1 fs solid 0.35 border lc rgb '{0}'", color_);
  }

  /// What stands for the whole series in the legend.
  std::string entry(const PlotSeries& series) const {
    const bool has_line = !series.curve.empty() || !series.guide.empty();
    const std::string line = series.curve.empty() ? dashed() : solid();
    if (series.points.empty()) return "lines " + line;
    if (series.mark == Mark::bar) return has_line ? "lines " + line : "boxes " + bar();
    if (!has_line) return "points " + symbol();
    return fmt::format("linespoints {} pt {} ps {}", line, shapes[shape_], shape_sizes[shape_]);
  }

 private:
  std::string_view color_;
  std::size_t shape_;
};

/// The data of a series, as gnuplot reads them; empty where there are none.
struct Blocks {
  std::string points, curve, guide;
  bool empty() const { return points.empty() && curve.empty() && guide.empty(); }
};

class Script {
 public:
  Script(const Plot& plot, std::string_view stem)
      : plot_(plot),
        stem_(stem),
        x_(plot.log_x, plot.whole_x ? PlotAxis::Tics::whole : PlotAxis::Tics::any),
        y_(plot.log_y),
        blocks_(plot.series.size()) {
    for (std::size_t i = 0; i < plot.series.size(); ++i) add_series(plot.series[i], blocks_[i]);
    for (const auto& series : plot.series)
      if (!series.label.empty()) longest_label_ = std::max(longest_label_, character_count(series.label));
    legend_entries_ = static_cast<std::size_t>(std::count_if(
        plot.series.begin(), plot.series.end(), [](const auto& series) { return !series.label.empty(); }));
  }

  std::optional<std::string> text() {
    if (std::all_of(blocks_.begin(), blocks_.end(), [](const auto& block) { return block.empty(); }))
      return std::nullopt;
    x_.pad(0.03);
    y_.pad(0.06);
    if (has_bars_ && y_.low() < 0) y_.begin_at(0);
    return head() + data() + frame() + titles() + legend() + drawing();
  }

 private:
  void add_series(const PlotSeries& series, Blocks& blocks) {
    for (const auto& point : series.points) add_point(point, blocks.points);
    for (const auto& point : series.curve) add_point(point, blocks.curve);
    for (const auto& point : series.guide) add_point(point, blocks.guide);
    if (series.mark != Mark::bar || blocks.points.empty()) return;
    has_bars_ = true;
    if (y_.holds(0)) y_.include(0);
    for (const auto& point : series.points)
      for (const double x : {point.x - series.bar_width / 2, point.x + series.bar_width / 2})
        if (x_.holds(x)) x_.include(x);
  }

  /// One line of data: x, y, and both ends of the error bar.
  void add_point(const PlotPoint& point, std::string& block) {
    if (!x_.holds(point.x) || !y_.holds(point.y)) {
      if (!block.empty() && !block.ends_with("\n\n")) block += '\n';  // a line is broken here
      return;
    }
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
      for (const auto& [name, block] :
           {std::pair{"series", &blocks_[i].points}, std::pair{"curve", &blocks_[i].curve},
            std::pair{"guide", &blocks_[i].guide}})
        if (!block->empty()) text += fmt::format("${}_{} << END\n{}END\n", name, i + 1, *block);
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

  /// Bars, lines, symbols, one over the other whatever the order of the series; then the legend.
  std::vector<std::string> layers() const {
    std::vector<std::string> bars, lines, symbols, entries;
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      const PlotSeries& series = plot_.series[i];
      const Blocks& blocks = blocks_[i];
      const Look look(series.look.value_or(i));
      if (!blocks.points.empty() && series.mark == Mark::bar)
        bars.push_back(fmt::format("$series_{} using 1:2:({}) with boxes {} notitle", i + 1,
                                   format_summary(0.9 * series.bar_width), look.bar()));
      if (!blocks.curve.empty())
        lines.push_back(fmt::format("$curve_{} using 1:2 with lines {} notitle", i + 1, look.solid()));
      if (!blocks.guide.empty())
        lines.push_back(fmt::format("$guide_{} using 1:2 with lines {} notitle", i + 1, look.dashed()));
      if (!blocks.points.empty() && series.mark == Mark::symbol)
        symbols.push_back(
            fmt::format("$series_{} using 1:2:3:4 with yerrorbars {} notitle", i + 1, look.symbol()));
      if (!series.label.empty() && !blocks.empty())
        entries.push_back(
            fmt::format("keyentry with {} title {}", look.entry(series), gnuplot_string(series.label)));
    }
    for (const auto* layer : {&lines, &symbols, &entries})
      bars.insert(bars.end(), layer->begin(), layer->end());
    return bars;
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
  std::vector<Blocks> blocks_;
  bool has_bars_ = false;
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
