#pragma once

#include <vector>

#include "ramify/shape/tropism.hpp"

namespace ramify {

/// The cylinder of a node: from the middle of one end to that of the other.
struct Limb {
  Point3 start, end;
  double radius;
};

/// A tree in space: the cylinder of every node by its preorder place, the external nodes' too (stalks of
/// leaves).
struct Shape {
  std::vector<Limb> limbs;
};

}  // namespace ramify
