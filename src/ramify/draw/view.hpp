#pragma once

#include <string>
#include <vector>

#include "ramify/shape/tropism.hpp"

namespace ramify {

/// From where a form is looked at, without perspective.
struct View {
  Point3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};  ///< at right angles, of length 1

  /// Seen from azimuth degrees to the right of the front and elevation degrees above the ground.
  static View from(double azimuth, double elevation);

  double across(const Point3& point) const { return along(right, point); }
  double upward(const Point3& point) const { return along(up, point); }
  /// Larger is nearer to who looks.
  double nearness(const Point3& point) const { return along(toward, point); }

 private:
  static double along(const Point3& axis, const Point3& point) {
    return axis[0] * point[0] + axis[1] * point[1] + axis[2] * point[2];
  }
};

/// front, right, back, left, top, bottom, oblique (30 degrees to the right and above), quarter (40 degrees to
/// the right), inverted (with the foot above).
const std::vector<std::string>& view_names();

/// Throws Error for another name, nearest names given.
View parse_view(const std::string& name);

}  // namespace ramify
