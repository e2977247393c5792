#pragma once

#include <cstdint>
#include <vector>

#include "ramify/shape/deviation_rule.hpp"
#include "ramify/shape/extent_rule.hpp"
#include "ramify/shape/plane_rule.hpp"
#include "ramify/shape/tropism.hpp"
#include "ramify/statistic/node_labels.hpp"

namespace ramify {

/// On which sides of the mother her children leave her.
enum class Arrangement : std::uint8_t {
  coplanar,  ///< two: one on each side; more: the main child between the others, which take sides in turn
  whorl,     ///< k: 360/k degrees from each other about the axis (E28 with X30)
};

/// How far a child's cylinder begins from the middle of the mother's end.
enum class Joint : std::uint8_t {
  centre,  ///< there (E1)
  legs,    ///< on the middle of its leg of the triangle over the mother's end (E7); of two children
};

/// All that makes a form of a tree.
struct ShapeRules {
  ExtentRule radius, length;
  DeviationRule deviation;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  PlaneRule plane = {};
  std::vector<Tropism> tropisms = {};  ///< in turn, of every branch but the root's
  // NOLINTEND(readability-redundant-member-init)
  Arrangement arrangement = Arrangement::coplanar;
  Joint joint = Joint::centre;
  MainChild main = MainChild::largest;
  bool mirrors = false;       ///< a coin for every fork: its sides are exchanged or not (E18 with X70)
  bool foreshortens = false;  ///< every deviation times cos(2 pi U), U uniform (E19)
};

}  // namespace ramify
