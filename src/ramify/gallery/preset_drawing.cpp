#include "ramify/gallery/preset_drawing.hpp"

#include <algorithm>
#include <utility>

#include "ramify/draw/sheet.hpp"
#include "ramify/shape/place_limbs.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

/// Rules know nothing of files.
Shape shape_of(const PicturePreset& preset, const PicturePanel& panel, const Tree& tree,
               const Cancellation& cancellation) {
  try {
    return panel_shape(panel, tree, cancellation);
  } catch (const Error& error) {
    throw located(error, {preset.file, 0, 0});
  }
}

}  // namespace

RecordedTree panel_tree(const PicturePanel& panel, const Cancellation& cancellation) {
  const TreeBatch batch{panel.model, panel.n, panel.seed, 1, false};
  return std::move(batch.grown(panel.replicate, panel.replicate + 1, cancellation).front());
}

Shape panel_shape(const PicturePanel& panel, const Tree& tree, const Cancellation& cancellation) {
  const StreamKey key{panel.seed, panel.model.stream_cell(panel.n)};
  Stream chance(key, panel.replicate, Lane::form);
  Shape shape = place_limbs(tree, panel.rules, chance, cancellation);
  if (panel.walk) {
    Stream steps(key, panel.replicate, Lane::limb_walk);
    shape.bends = bends_of_walks(shape.limbs, *panel.walk, steps);
  }
  return shape;
}

double expected_pieces(const PicturePanel& panel, Size n) {
  return expected_nodes(panel.model, n) * (panel.walk ? static_cast<double>(panel.walk->steps) : 1);
}

double expected_pieces(const PicturePreset& preset) {
  double pieces = 0;
  for (const PicturePanel& panel : preset.panels) pieces += expected_pieces(panel, panel.n);
  return pieces;
}

Drawing preset_drawing(const PicturePreset& preset, double side, const Cancellation& cancellation) {
  const bool has_captions =
      std::ranges::any_of(preset.panels, [](const PicturePanel& panel) { return !panel.caption.empty(); });
  Sheet sheet(preset.panels.size(), preset.columns, has_captions, side);
  for (const PicturePanel& panel : preset.panels) {
    const RecordedTree tree = panel_tree(panel, cancellation);
    sheet.add(panel.caption, tree.tree, shape_of(preset, panel, tree.tree, cancellation), panel.look,
              cancellation);
  }
  return sheet.drawing();
}

}  // namespace ramify
