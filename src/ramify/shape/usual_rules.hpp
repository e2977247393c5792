#pragma once

#include <cstdint>

#include "ramify/shape/shape.hpp"
#include "ramify/shape/shape_rules.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The thesis's own form (E21; Kruszewski 1996, 2.3): R = leaves^(1/3), L = 10 R, Murray's angle, divergence
/// 137.5 degrees. Where the tree has a fork of three children or more, deviations are those of catalogue E28.
ShapeRules thesis_rules(const Tree& tree);

/// The form of a tree that was measured: its own lengths and radii; where it has none, every length 1, and
/// radii by Leonardo's rule (R^2 is the sum of the children's) from a 40th of the longest path at the foot.
/// Files of trees say nothing of angles that is read: the siblings' part of 70 degrees, divergence 137.5.
///
/// Throws Error where a length or radius is not known, negative or infinite; the root's own length may be
/// unknown.
/// @param tree  lives as long as the rules
ShapeRules measured_rules(const RecordedTree& tree);

/// Which of a file's coordinates points up: neurons are drawn with y, trees in a wood are measured with z.
enum class Upwards : std::uint8_t { y, z };

/// The form of a tree whose file has the places of its nodes: every limb ends at its own and begins at that
/// of its parent, the root's has no length. Throws Error where a radius is not known, negative or infinite.
/// O(nodes).
Shape measured_shape(const RecordedTree& tree, Upwards upwards);

}  // namespace ramify
