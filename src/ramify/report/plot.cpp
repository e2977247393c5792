#include "ramify/report/plot.hpp"

#include <system_error>

#include <fmt/format.h>

#include "ramify/io/atomic_file.hpp"
#include "ramify/report/gnuplot.hpp"
#include "ramify/report/plot_script.hpp"

namespace ramify {
namespace {

bool is_drawn(const std::filesystem::path& picture) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(picture, ignored);
  return !ignored && size > 0;
}

}  // namespace

PlotFiles write_plot(const Plot& plot, const std::filesystem::path& folder, std::string_view stem) {
  PlotFiles files;
  const auto script = detail::plot_script(plot, stem);
  if (!script) {
    files.status = PlotStatus::no_points;
    return files;
  }
  files.script = folder / fmt::format("{}.gp", stem);
  files.svg = folder / fmt::format("{}.svg", stem);
  files.png = folder / fmt::format("{}.png", stem);
  write_file_atomically(files.script, *script);
  // A picture of an earlier run must not pass for this one's.
  std::error_code ignored;
  for (const auto* picture : {&files.svg, &files.png}) std::filesystem::remove(*picture, ignored);
  const auto result = detail::run_gnuplot(folder, fmt::format("{}.gp", stem));
  if (result.exit_code == 0 && is_drawn(files.svg) && is_drawn(files.png)) return files;
  files.status = result.exit_code == detail::not_installed ? PlotStatus::no_gnuplot : PlotStatus::failed;
  files.message = result.output;
  for (auto* picture : {&files.svg, &files.png}) {
    std::filesystem::remove(*picture, ignored);
    picture->clear();
  }
  return files;
}

std::string why_not_drawn(const PlotFiles& files) {
  switch (files.status) {
    case PlotStatus::no_points:
      return "there is no value to draw";
    case PlotStatus::no_gnuplot:
      return detail::gnuplot_complaint(detail::not_installed, files.message);
    case PlotStatus::failed:
      return detail::gnuplot_complaint(1, files.message);
    case PlotStatus::drawn:
      break;
  }
  return "";
}

}  // namespace ramify
