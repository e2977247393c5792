#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/draw/drawing.hpp"
#include "ramify/gallery/picture_preset.hpp"
#include "ramify/shape/shape.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The tree of a panel: that of the row `ramify sample --no-graft` prints for its model, n, seed and
/// replicate. Throws Interrupted.
RecordedTree panel_tree(const PicturePanel& panel, const Cancellation& cancellation);

/// The form that the panel's rules give its tree. What is random in them comes from a stream of the tree's
/// own, the walks of its branches from another: their ends are the same with and without.
Shape panel_shape(const PicturePanel& panel, const Tree& tree, const Cancellation& cancellation);

/// Nodes of a panel's tree of that size in the mean, each as often as its branch has pieces: one, or the
/// steps of a walk.
double expected_pieces(const PicturePanel& panel, Size n);

/// Of all its trees, so that what is too much is refused before it is grown.
double expected_pieces(const PicturePreset& preset);

/// A sheet: every panel in a box of the same size (G12), row by row, its caption below. Throws Interrupted.
/// @param side  of a picture of one panel, in units of the page
Drawing preset_drawing(const PicturePreset& preset, double side, const Cancellation& cancellation);

}  // namespace ramify
