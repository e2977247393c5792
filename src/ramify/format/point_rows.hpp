#pragma once

#include <string_view>
#include <vector>

#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify::detail {

/// A point of a neuron, as SWC has it.
struct Point {
  static constexpr int soma = 1;

  std::string_view id, parent;  ///< parts of the text; no parent is empty
  int type = 0;                 ///< 1 soma, 2 axon, 3 dendrite, 4 apical dendrite; 0 where it is not said
  double x = 0, y = 0, z = 0;
  double radius = 0;  ///< NaN where it is unknown

  bool is_soma() const { return type == soma; }
};

/// The points of a text: with a header as point_columns() knows it, in a comment too, or the seven columns of
/// SWC. What is not read is remarked. Throws Error with line and column for short lines, ids that are no
/// whole numbers, coordinates that are none.
std::vector<Point> read_points(const SourceText& source, Remarks& remarks);

/// Whether a row without a header may be a point of SWC: seven fields, ids and type whole, all numbers.
bool is_point_row(const std::vector<std::string_view>& fields);

/// The distance of two points.
double distance(const Point& a, const Point& b);

}  // namespace ramify::detail
