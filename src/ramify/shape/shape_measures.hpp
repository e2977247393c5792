#pragma once

#include <vector>

#include "ramify/shape/shape.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// Of the cylinders of one order; internal nodes alone.
struct OrderExtents {
  unsigned order;  ///< leaf order 1: from 2 on
  double cylinders;
  double streams;
  double mean_radius;         ///< of a cylinder
  double mean_length;         ///< of a cylinder
  double mean_stream_length;  ///< of a chain of cylinders of the order: Horton's second law is about it (X72)
};

/// Measures of a form (B24), of its internal nodes: external ones are leaves.
struct ShapeMeasures {
  double volume;   ///< sum of pi R^2 L
  double surface;  ///< sum of 2 pi R L, the sides alone
  double height;   ///< highest end over the foot; lower ends than the foot do not count
  double spread;   ///< largest distance of an end from the vertical through the foot
  double length;   ///< of all cylinders
  std::vector<OrderExtents> orders;
};

/// @param shape  of that tree. O(nodes).
ShapeMeasures measure_shape(const Tree& tree, const Shape& shape);

}  // namespace ramify
