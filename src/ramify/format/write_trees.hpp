#pragma once

#include <string>
#include <vector>

#include "ramify/format/tree_format.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The formats that are written: newick, swc, edges, parens, json.
const std::vector<TreeFormat>& written_formats();

/// The trees as a text that read_trees turns into the same trees again, left and right included; names,
/// lengths and radii as far as the format has room for them. O(nodes).
/// @param format  one of written_formats()
std::string write_trees(const std::vector<RecordedTree>& trees, TreeFormat format);

}  // namespace ramify
