#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "ramify/core/cancellation.hpp"
#include "ramify/draw/drawing.hpp"
#include "ramify/io/picture_format.hpp"

namespace ramify {

/// The drawing as an SVG document, by Cairo. Throws Error where Cairo fails, Interrupted when cancelled.
std::string svg_of(const Drawing& drawing, const Cancellation& cancellation);

/// A file for one drawing, SVG or PNG (a pixel a unit) as its name ends; by Cairo.
class DrawingFile {
 public:
  /// Throws Error for a name with another ending.
  explicit DrawingFile(std::filesystem::path path);

  /// Throws Error where a tree of so many nodes is too large for the format, and says what would do.
  void require_room(double nodes) const;

  /// The file is written whole or not at all. Throws Error where it cannot be, or where Cairo fails, and
  /// Interrupted when cancelled.
  void write(const Drawing& drawing, const Cancellation& cancellation) const;

 private:
  std::filesystem::path path_;
  PictureFormat format_;
};

}  // namespace ramify
