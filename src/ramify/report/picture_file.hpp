#pragma once

#include <filesystem>
#include <string>

#include "ramify/io/picture_format.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// A plot as gnuplot drew it; or no bytes, and why.
struct DrawnPlot {
  std::string bytes;
  std::string why_not;  ///< "gnuplot is not installed"
  std::string remedy;   ///< what to do about that
};

/// Has gnuplot draw the plot, 1000 by 640. Throws Error where no temporary file can be written.
DrawnPlot draw_plot(const Plot& plot, PictureFormat format);

/// A file for one plot, SVG or PNG as its name ends: what `--plot` takes.
class PictureFile {
 public:
  /// Throws Error for a name with another ending.
  explicit PictureFile(std::filesystem::path path);

  /// Has gnuplot draw the plot, 1000 by 640; the file is written whole or not at all. Throws Error where
  /// there is nothing to draw, where gnuplot is not installed or fails, and where the file cannot be written.
  void draw(const Plot& plot) const;

 private:
  std::filesystem::path path_;
  PictureFormat format_;
};

}  // namespace ramify
