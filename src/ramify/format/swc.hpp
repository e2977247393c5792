#pragma once

#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads SWC: a point a line, `id type x y z radius parent`, parent -1 for a root; `#` begins a comment,
/// anywhere. The same as a table with a header, by its columns (point_columns).
///
/// Every point is a node; its length is the distance from its parent point, its radius the point's own, none
/// where that is -1; its place is the point's. A root has no length. All soma points (type 1) that hang
/// together are one node, the root, whatever contour or sphere they describe and wherever they stand in the
/// file: where another point has no parent, the edges from there to the soma turn round. `neurites` as root
/// takes every subtree that leaves a soma as a tree of its own. Other types only name such trees:
/// "file#5:axon". What is not read, soma points that lie more than two radii from the first, and a tree of
/// soma points alone are remarked.
///
/// Throws Error with line and column for a short line, an id, coordinate or radius that is no number, an id
/// twice, a missing parent, a cycle, several roots where one is needed. O(points) time.
std::vector<RecordedTree> read_swc(SourceText source, const ReadOptions& options, Remarks& remarks);

/// Trees as SWC, for viewers: the root is a soma point, all others are dendrite (type 3); x is the middle of
/// the leaves below, y the depth, z 0, and the radius follows Murray's law, 0.1 times the cube root of the
/// number of leaves. Several trees go on with their ids. Branching alone is kept of a tree. O(nodes).
std::string write_swc(const std::vector<RecordedTree>& trees);

}  // namespace ramify
