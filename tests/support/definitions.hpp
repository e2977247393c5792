#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
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

/// The level of the highest node with fewer than two children, which is the fill level of trees of any arity.
std::size_t level_of_first_gap(const Shape& shape);

/// Maximum over root-to-leaf paths of the edges to a child no larger than any of its siblings (B16).
std::size_t balance(const Shape& shape);

/// The law of the depth of the last node (B23): every walk with its probability; depth 0 for an external
/// node.
std::map<std::size_t, double> last_node_depth_law(const Shape& shape);

/// The law of the depth (root = 1) of an external node drawn uniformly (B23): every one of them.
std::map<std::size_t, double> external_depth_law(const Shape& shape);

/// Sum of the depths of all internal nodes, in edges from the root: every node's path is counted.
std::uint64_t path_length(const Shape& shape);

/// The same for all external nodes.
std::uint64_t sackin(const Shape& shape);

/// Sum over the nodes with two children of the difference of their numbers of external nodes; NaN where a
/// node has three children or more.
double colless(const Shape& shape);

/// Sum over the pairs of external nodes of the depth, in edges, of their last common node.
double total_cophenetic(const Shape& shape);

/// 3 times the quartets of external nodes that part two and two at their last common node; binary trees.
double rooted_quartets(const Shape& shape);

/// Sum of 1 over the height, in edges, of every internal node but the root.
double b1(const Shape& shape);

/// Entropy, in bits, of the external node that a walk reaches which turns to every child alike.
double b2(const Shape& shape);

/// Mean and variance (divisor m) of the depths, in edges, of all m external nodes.
double average_leaf_depth(const Shape& shape);
double variance_leaf_depth(const Shape& shape);

/// Of the nodes with two children the share whose sides have different numbers of external nodes, and the
/// mean of the smaller over the larger; NaN where there is no such node. Trees of at most two children a
/// node.
double stairs1(const Shape& shape);
double stairs2(const Shape& shape);

/// Nodes with two children, whose subtrees are not the same when left and right are not told apart. Trees of
/// at most two children a node, one-child nodes contracted.
std::uint64_t symmetry_nodes(const Shape& shape);

/// Nodes with two children or more and three external nodes below them.
std::uint64_t pitchforks(const Shape& shape);

/// Mean over the internal nodes, weighted by the external nodes below, of the entropy of how these divide
/// among the children, to the base of their number; 0 of a one-child node. NaN of a single external node.
double j1(const Shape& shape);

/// Nodes with two children or more, all of them external once one-child nodes are contracted.
std::uint64_t cherries(const Shape& shape);

/// The fewest registers with which the tree can be evaluated as an expression (B21): every order of
/// evaluation is tried at every node. Leaves are loaded, an operator needs all its operands in registers and
/// frees all but one. Strict binary trees.
std::size_t registers(const Shape& shape);

/// Nodes of order i whose two children of highest order have the orders high and low (B13), at {high, low}.
std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> bi_orders(const Shape& shape);

/// Streams of order j that end at a node of a stream of order i > j and do not take part in beginning it
/// (Tokunaga 1978), at {i, j}.
std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> side_branches(const Shape& shape);

/// Mean over k of counts[k] / counts[k+1] (B11a).
double mean_ratio(const std::vector<std::uint64_t>& counts);

}  // namespace ramify::test
