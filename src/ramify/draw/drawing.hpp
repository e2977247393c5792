#pragma once

#include <array>
#include <string>
#include <vector>

namespace ramify {

/// A place on the page: x to the right, y down.
struct PagePoint {
  double x, y;
};

/// Red, green and blue, from 0 to 1.
using Color = std::array<double, 3>;

/// Straight lines with round ends, all of one colour and width.
struct Stroke {
  struct Line {
    PagePoint from, to;
  };

  Color color;
  double width;
  std::vector<Line> lines;
};

/// A line of text; its middle height lies on the place.
struct Label {
  enum class Anchor { start, middle };

  PagePoint place;
  std::string text;  ///< UTF-8
  double size;
  Anchor anchor = Anchor::start;
  bool upward = false;  ///< turned by a quarter, to be read from below
};

/// What is drawn, as a list of primitives in the units of a page, before any surface: strokes in their order,
/// then labels.
struct Drawing {
  double width, height;
  std::vector<Stroke> strokes;
  std::vector<Label> labels;
};

}  // namespace ramify
