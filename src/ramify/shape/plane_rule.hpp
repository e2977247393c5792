#pragma once

#include <cstdint>
#include <vector>

#include "ramify/shape/rule_info.hpp"

namespace ramify {

/// How the plane in which a node's children lie is turned about the node's axis.
struct PlaneRule {
  enum class Kind : std::uint8_t {
    carried,     ///< from the mother's plane by the angle
    horizontal,  ///< on the trunk as carried; elsewhere across the axis and level with the ground
    gradient,    ///< level with the ground, then by the angle for every level from the root
    random,      ///< from the mother's plane by a uniform angle up to the whole turn
  };

  Kind kind = Kind::carried;
  double angle = 0;  ///< degrees
};

/// All rules for planes, in the order they are listed.
const std::vector<RuleInfo<PlaneRule>>& plane_rules();

/// Fraction i of the law of Schimper and Braun as an angle, F_i/F_(i+2) of 360 degrees: 180, 120, 144, 135,
/// ... to 137.5078. @param i  from 1 to 40. E5 with X21; Jean 1978.
double schimper_braun_angle(unsigned i);

}  // namespace ramify
