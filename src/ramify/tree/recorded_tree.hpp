#pragma once

#include <array>
#include <string>
#include <vector>

#include "ramify/tree/node_names.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// A tree as somebody recorded it: the branching, and what the file says of every node, by its preorder
/// place.
///
/// A node stands for the piece of branch between its parent and itself. Lengths and radii are in the file's
/// own unit; the vectors are empty where the file has none, an element is NaN where one node has none.
struct RecordedTree {
  std::string name;  ///< the file, and the place in it where it holds several trees
  Tree tree;
  std::vector<double> lengths;
  std::vector<double> radii;
  NodeNames names;  ///< labels or ids
  /// x, y and z of every node's end, in the file's unit; empty where the file has none.
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::vector<std::array<double, 3>> places = {};
};

}  // namespace ramify
