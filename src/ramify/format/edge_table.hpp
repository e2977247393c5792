#pragma once

#include <string>
#include <vector>

#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Trees as a table `[tree,]id,parent[,length][,radius][,name]` that read_tree_table reads back unchanged:
/// nodes in preorder, numbered from 1, the root's parent 0. With several trees a first column counts them
/// from 1. O(nodes).
std::string write_edge_table(const std::vector<RecordedTree>& trees);

}  // namespace ramify
