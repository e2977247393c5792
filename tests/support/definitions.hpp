#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "support/shape.hpp"

namespace ramify::test {

// Every statistic as its definition reads, on explicit nodes: recursive and quadratic. Catalogue entries in
// parentheses.

std::uint64_t internal_nodes(const Shape& shape);
std::uint64_t external_nodes(const Shape& shape);

/// Horton-Strahler order (B6, B22): 0 for an external node; m+1 where two or more children have the largest
/// order m, else m.
std::size_t strahler(const Shape& shape);

/// The same number by pruning, for shapes without one-child nodes: how often all external nodes can be cut
/// off, and the one-child nodes that arise contracted, until a single node is left.
std::size_t strahler_by_pruning(const Shape& shape);

/// Nodes of every order 0..S (B9).
std::vector<std::uint64_t> nodes_per_order(const Shape& shape);

/// Streams of every order 0..S (B8): classes of nodes joined by the edges whose two ends have the same order.
std::vector<std::uint64_t> streams_per_order(const Shape& shape);

/// Nodes on the longest path from the root to an external node (B4): every path is walked.
std::size_t height(const Shape& shape);

/// Nodes on every level, the root's first.
std::vector<std::uint64_t> nodes_per_level(const Shape& shape);

/// The deepest level l such that levels 0..l have all their 2^l nodes (B18); strict binary trees.
std::size_t fill_level(const Shape& shape);

/// The level of the highest external node, which is the fill level of trees of any arity.
std::size_t level_of_first_leaf(const Shape& shape);

/// Maximum over root-to-leaf paths of the edges to a child no larger than any of its siblings (B16).
std::size_t balance(const Shape& shape);

/// The law of the depth of the last node (B23): every walk with its probability; depth 0 for an external
/// node.
std::map<std::size_t, double> last_node_depth_law(const Shape& shape);

/// Mean over k of counts[k] / counts[k+1] (B11a).
double mean_ratio(const std::vector<std::uint64_t>& counts);

}  // namespace ramify::test
