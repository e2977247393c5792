#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/shape/shape.hpp"
#include "ramify/shape/shape_rules.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// The form that rules give a tree, by one frame algorithm (catalogue E1; Kruszewski 1996, 2.1.2).
///
/// A frame is a heading h, a normal e across it and n = h x e. A child turned by T to the side u = e cos(a) +
/// n sin(a) has the heading h cos T + u sin T; its frame is the mother's turned about h x u, then drawn by
/// the tropisms, then rolled about its own heading by the plane rule. It ends at its start + length x
/// heading. The root starts at the origin and goes up; e is (-1,0,0), so that a first child is on the left of
/// who looks from the front.
///
/// What is random is drawn from the stream fork by fork in preorder. Throws Error where a rule gives a radius
/// or a length that is negative or no number, or an angle that is none; Interrupted. O(nodes) time, some 90
/// bytes a node.
Shape place_limbs(const Tree& tree, const ShapeRules& rules, Stream& chance,
                  const Cancellation& cancellation);

}  // namespace ramify
