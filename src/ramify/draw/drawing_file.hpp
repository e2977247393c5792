#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "ramify/core/cancellation.hpp"
#include "ramify/draw/drawing.hpp"

namespace ramify {

/// The drawing as an SVG document, by Cairo. Throws Error where Cairo fails, Interrupted when cancelled.
std::string svg_of(const Drawing& drawing, const Cancellation& cancellation);

enum class DrawingFormat : std::uint8_t { svg, pdf, postscript, png };

/// As the name ends: .svg, .pdf, .ps or .png. Throws Error for another ending.
DrawingFormat drawing_format(const std::filesystem::path& path);

/// A file for one drawing, SVG, PDF, PostScript or PNG (a pixel a unit) as its name ends; by Cairo. The same
/// bytes for the same drawing.
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
  std::string bytes_of(const Drawing& drawing, const Cancellation& cancellation) const;

  std::filesystem::path path_;
  DrawingFormat format_;
};

}  // namespace ramify
