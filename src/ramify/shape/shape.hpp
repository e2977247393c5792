#pragma once

#include <cstddef>
#include <span>
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
  /// Of limbs that are no straight lines, places between their ends: as many of each, limb by limb.
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::vector<Point3> bends = {};

  std::span<const Point3> bends_of(std::size_t limb) const {
    const std::size_t each = bends.size() / limbs.size();
    return std::span(bends).subspan(limb * each, each);
  }
};

}  // namespace ramify
