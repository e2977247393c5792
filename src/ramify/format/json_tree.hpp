#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads trees as JSON, one object a line:
///   {"name": "...", "parent": [-1,0,1,1,0], "length": [...], "radius": [...], "label": [...]}
/// Nodes are places in the lists, in preorder; parent gives the place of each node's parent, -1 for the root,
/// which is first. Flat lists, since a nested tree of great height is more than most readers of JSON stand.
/// Other keys are remarked; null stands for no number.
///
/// Throws Error with line and column where it is no JSON, lists have different lengths, or the nodes are not
/// in preorder. O(size).
std::vector<RecordedTree> read_json_trees(SourceText source, Remarks& remarks);

/// One such line. Nothing of a tree is lost, but bytes in names that are no UTF-8. O(nodes).
std::string write_json_tree(const RecordedTree& recorded);

}  // namespace ramify
