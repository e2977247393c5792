#pragma once

#include <array>
#include <cstdint>
#include <span>
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

/// Filled outlines, each over those before it. A few vectors for all of them: a tree has a million.
class Patches {
 public:
  enum class Step : std::uint8_t { move, line, curve };  ///< with 1, 1 and 3 points

  struct Patch {
    std::array<float, 3> color;
    std::size_t first_step, first_point;
  };

  /// Begins an outline; what follows belongs to it until the next. It closes itself.
  void begin(const Color& color, PagePoint from);
  void line(PagePoint to);
  /// A cubic Bezier curve.
  void curve(PagePoint first_handle, PagePoint second_handle, PagePoint to);

  /// All of another drawing's, shrunk or enlarged and moved.
  void append(const Patches& other, PagePoint at, double scale);

  std::size_t count() const { return patches_.size(); }
  Color color(std::size_t patch) const;
  std::span<const Step> steps(std::size_t patch) const;
  /// Those of its steps, one after the other.
  std::span<const PagePoint> points(std::size_t patch) const;

 private:
  std::vector<Patch> patches_;
  std::vector<Step> steps_;
  std::vector<PagePoint> points_;
};

/// What is drawn, as a list of primitives in the units of a page, before any surface: patches in their order,
/// then strokes, then labels.
struct Drawing {
  double width, height;
  std::vector<Stroke> strokes;
  std::vector<Label> labels;
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  Patches patches = {};
};

/// Adds a drawing to a page, shrunk or enlarged, its upper left corner in a place.
void add_drawing(Drawing& page, const Drawing& part, PagePoint at, double scale);

}  // namespace ramify
