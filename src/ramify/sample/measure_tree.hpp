#pragma once

#include "ramify/random/stream.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// What is read off a stored tree of any arity, in one pass; the walks to the last and to an external node
/// take their choices from (key, replicate). O(nodes); orders and height alone in a third of the time of all
/// but indices.
/// @param tree   at least one node; HortonStrahler::orders orders at most, so fewer than 2^63 external nodes
/// @param folds  what is needed: the rest may be left out
TreeMeasures measure_tree(const Tree& tree, StreamKey key, std::uint64_t replicate,
                          FoldSet folds = all_folds);

}  // namespace ramify
