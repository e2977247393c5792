#pragma once

#include "ramify/random/stream.hpp"
#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// Every statistic of a stored tree of any arity, in one pass; the walks to the last and to an external node
/// take their choices from (key, replicate). O(nodes).
/// @param tree  at least one node; HortonStrahler::orders orders at most, so fewer than 2^63 external nodes
TreeMeasures measure_tree(const Tree& tree, StreamKey key, std::uint64_t replicate);

/// Order, height and counts of nodes and streams alone, in a third of the time. tree: as of measure_tree.
TreeMeasures measure_orders_and_height(const Tree& tree);

}  // namespace ramify
