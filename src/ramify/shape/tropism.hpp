#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ramify/shape/rule_info.hpp"

namespace ramify {

/// A place or a direction in space: x to the right, y up, z towards the viewer.
using Point3 = std::array<double, 3>;

/// What draws a branch from the direction that its fork gave it.
struct Tropism {
  enum class Kind : std::uint8_t {
    lean,        ///< heading + strength target, of length 1 again
    torque,      ///< turned to the target by strength |heading x target| radians
    pull,        ///< the angle to the target divided by 1 + strength (nodes/nodes of the root)^exponent
    bend,        ///< the same with 1 - (nodes/nodes of the root)^exponent: small branches give way most
    shift,       ///< the end moved by the target
    controller,  ///< the end moved towards the target by strength, away from it where negative
  };

  Kind kind = Kind::lean;
  double strength = 0;
  Point3 target{0, 1, 0};
  double exponent = 0.25;
  double first_level = 0, last_level = 1e9;  ///< of a controller: forks below the branch
};

/// All of them, in the order they are listed.
const std::vector<RuleInfo<Tropism>>& tropism_rules();

}  // namespace ramify
