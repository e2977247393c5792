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
  coplanar,     ///< two: one on each side; more: the main child between the others, which take sides in turn
  alternating,  ///< as coplanar, but for the trunk's forks the sides are exchanged at every even depth (F9)
  whorl,        ///< k: 360/k degrees from each other about the axis (E28 with X30)
  turned,       ///< at the azimuths of the rules, and each child's plane is turned with it, as a turtle rolls
                ///< (F11)
};

/// How far a child's cylinder begins from the middle of the mother's end.
enum class BranchJoint : std::uint8_t {
  centre,  ///< there (E1)
  legs,    ///< so that both touch in a point of their rims, on the side to which the child turns: on the
           ///< middle of its leg of the triangle over the mother's end (E7)
  sides,   ///< as far, and the notch that is left between the two ends is filled where it is drawn (G2)
};

/// All that makes a form of a tree.
struct ShapeRules {
  ExtentRule radius, length;
  DeviationRule deviation;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  PlaneRule plane = {};
  std::vector<double> azimuths = {};   ///< degrees, of Arrangement::turned; children beyond them begin again
  std::vector<Tropism> tropisms = {};  ///< in turn, of every branch but the root's
  // NOLINTEND(readability-redundant-member-init)
  Arrangement arrangement = Arrangement::coplanar;
  BranchJoint joint = BranchJoint::centre;
  MainChild main = MainChild::largest;
  bool mirrors = false;       ///< a coin for every fork: its sides are exchanged or not (E18 with X70)
  bool foreshortens = false;  ///< every deviation times cos(2 pi U), U uniform (E19)
};

}  // namespace ramify
