#include "sample_trees.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "ramify/draw/drawing_file.hpp"
#include "ramify/draw/sheet.hpp"
#include "ramify/gallery/preset_drawing.hpp"
#include "ramify/page/shell_word.hpp"
#include "ramify/shape/usual_rules.hpp"

namespace ramify {
namespace {

bool takes_trees_of(const Claim& claim, const Model& model) {
  return std::ranges::any_of(claim.parts, [&](const ClaimPart& part) { return part.model == model; });
}

SampleTree sample_tree(const Model& model, std::uint64_t seed, const Cancellation& cancellation) {
  constexpr Size nodes = 100;  // branches can still be told apart
  constexpr double side = 400;
  PicturePanel panel{{}, model, nodes, seed, 0, {}, {}};
  const RecordedTree tree = panel_tree(panel, cancellation);
  panel.rules = thesis_rules(tree.tree);
  panel.look.by_order = true;
  Sheet sheet(1, 1, false, side);
  sheet.add({}, tree.tree, panel_shape(panel, tree.tree, cancellation), panel.look, cancellation);
  return {model, nodes, seed, svg_of(sheet.drawing(), cancellation)};
}

}  // namespace

std::string SampleTree::anchor() const {
  std::string anchor = "tree-";
  for (const char c : model.text()) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      anchor += c;
    else if (anchor.back() != '-')
      anchor += '-';
  }
  if (anchor.back() == '-') anchor.pop_back();
  return anchor;
}

std::string SampleTree::command() const {
  return fmt::format("ramify draw --model {} --n {} --seed {} --style branches -o tree.svg",
                     shell_word(model.text()), n, seed);
}

std::vector<SampleTree> sample_trees(const std::vector<const Claim*>& claims, std::uint64_t seed,
                                     const Cancellation& cancellation) {
  std::vector<SampleTree> trees;
  for (const Claim* claim : claims)
    for (const ClaimPart& part : claim->parts)
      if (part.model && std::ranges::find(trees, *part.model, &SampleTree::model) == trees.end())
        trees.push_back(sample_tree(*part.model, seed, cancellation));
  return trees;
}

std::vector<const SampleTree*> trees_of(const Claim& claim, const std::vector<SampleTree>& trees) {
  std::vector<const SampleTree*> own;
  for (const SampleTree& tree : trees)
    if (takes_trees_of(claim, tree.model)) own.push_back(&tree);
  return own;
}

}  // namespace ramify
