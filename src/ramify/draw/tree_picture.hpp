#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/draw/drawing.hpp"
#include "ramify/draw/tree_look.hpp"
#include "ramify/shape/shape.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// A rectangle on the page.
struct PageBox {
  double left, top, width, height;
};

/// Adds the picture of a form, as large as the box allows, its foot's middle line in the middle only where
/// the form is symmetric: the box of the form lies in the middle of that of the page. Internal nodes are
/// branches, external ones leaves, or nothing. What is nearer lies over what is farther, children over their
/// mothers.
///
/// @param shape  of that tree. Throws Interrupted. O(nodes log nodes) time, some 150 bytes a node.
void add_tree(Drawing& drawing, const PageBox& box, const Tree& tree, const Shape& shape,
              const TreeLook& look, const Cancellation& cancellation);

}  // namespace ramify
