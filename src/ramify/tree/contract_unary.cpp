#include "ramify/tree/contract_unary.hpp"

#include <algorithm>
#include <limits>

#include "ramify/tree/branch_pieces.hpp"

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The chain from `first` to `last`, nodes that follow each other in preorder.
BranchPieces chain(const RecordedTree& tree, std::size_t first, std::size_t last) {
  BranchPieces pieces;
  for (std::size_t node = first; node <= last; ++node)
    pieces.add(tree.lengths.empty() ? none : tree.lengths[node],
               tree.radii.empty() ? none : tree.radii[node]);
  return pieces;
}

}  // namespace

RecordedTree contract_unary(RecordedTree tree) {
  const auto arities = tree.tree.arities();
  if (std::ranges::find(arities, 1u) == arities.end()) return tree;
  RecordedTree contracted;
  contracted.name = std::move(tree.name);
  std::vector<std::uint32_t> arity;
  for (std::size_t first = 0; first < arities.size();) {
    std::size_t last = first;
    while (arities[last] == 1) ++last;
    const BranchPieces branch = chain(tree, first, last);
    if (!tree.lengths.empty()) contracted.lengths.push_back(branch.length());
    if (!tree.radii.empty()) contracted.radii.push_back(branch.radius());
    if (!tree.places.empty()) contracted.places.push_back(tree.places[last]);
    contracted.names.set(arity.size(), tree.names[last]);
    arity.push_back(arities[last]);
    first = last + 1;
  }
  contracted.tree = Tree(std::move(arity));
  return contracted;
}

}  // namespace ramify
