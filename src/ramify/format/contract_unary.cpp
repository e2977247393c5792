#include "ramify/format/contract_unary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Length and mean radius of the chain from `first` to `last`, nodes that follow each other in preorder.
struct Chain {
  double length = none, radius = none;

  Chain(const RecordedTree& tree, std::size_t first, std::size_t last) {
    double lengths = 0, weighted = 0, weights = 0, radii = 0, count = 0;
    bool any_length = false;
    for (std::size_t node = first; node <= last; ++node) {
      const double piece = tree.lengths.empty() ? none : tree.lengths[node];
      const double radius_here = tree.radii.empty() ? none : tree.radii[node];
      if (!std::isnan(piece)) {
        any_length = true;
        lengths += piece;
      }
      if (std::isnan(radius_here)) continue;
      radii += radius_here;
      ++count;
      if (!(piece > 0)) continue;
      weighted += piece * radius_here;
      weights += piece;
    }
    if (any_length) length = lengths;
    if (count > 0) radius = weights > 0 ? weighted / weights : radii / count;
  }
};

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
    const Chain chain(tree, first, last);
    if (!tree.lengths.empty()) contracted.lengths.push_back(chain.length);
    if (!tree.radii.empty()) contracted.radii.push_back(chain.radius);
    contracted.names.set(arity.size(), tree.names[last]);
    arity.push_back(arities[last]);
    first = last + 1;
  }
  contracted.tree = Tree(std::move(arity));
  return contracted;
}

}  // namespace ramify
