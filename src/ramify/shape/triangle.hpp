#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "ramify/shape/degrees.hpp"

namespace ramify {

/// The triangle on the far end of a Pythagoras tree's square, on whose legs the next two squares stand (E7):
/// its angles at the ends of the base, in degrees, the first child's first.
struct Triangle {
  double first, second;
  bool flips;  ///< the two change places at every even depth

  /// The angle at a child's end of the base: by so much the child turns away from the mother.
  double angle(std::size_t child, double depth_of_mother) const {
    const bool is_flipped = flips && std::fmod(depth_of_mother, 2) == 0;
    return (child == 0) != is_flipped ? first : second;
  }

  /// A child's leg as part of the base (law of sines).
  double leg(std::size_t child, double depth_of_mother) const {
    const double other = angle(child == 0 ? 1 : 0, depth_of_mother);
    return std::sin(radians(other)) / std::sin(radians(first + second));
  }
};

}  // namespace ramify
