#pragma once

#include "ramify/compare/interval.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// E M_k, Cov(M_j, M_k) and P(S >= s), s and k from the leaves' 0 on, of the ternary trees of n nodes of
/// ternary(p) and node_ternary(P) (K96 3.3.3, 3.3.4; A22 to A24). The order of a node is the largest of its
/// children's, one more where two or three have it (B22); a stream of order k begins where no child has that
/// order.
///
/// Exact but for rounding, some 1e-11: by recurrence over the sizes, of node_ternary over sizes and depths,
/// that a node of the tree has; what is expected less than 1e-18 times in a tree is left out. Throws
/// Interrupted. Cost: at n = 1000 some 0.3 s, of node_ternary 2 s.
StreamCounts ternary_stream_counts(const Model& model, Size n, const Cancellation& cancellation);

/// The orders that are left to a tree of n nodes of ternary(p) but for a chance; also to one whose p is
/// another, 1/3 at most, at sizes to 100, where log(4n/chance) >= 200 p^2: the bounds stop above them.
///
/// X of m nodes lies within t(m) = sqrt(m L/2) of m p but for a chance of 4 e^-L (Hoeffding 1963, and P(X <=
/// m/2) >= 1/2, on which it is conditioned); with L = log(4n/chance) all nodes of the tree obey. Then no
/// child is smaller than l(m) = min(p m - t - 1, (1-2p) m - 2t), and three children of order k make one of
/// k+1; and no child but the main one is larger than u(m) = min(m/2, p m + t), while an order that is not the
/// main child's is one more than a side child's at most. How often l and u can be taken until no node is left
/// bounds S from both sides; both counts are log n/log(1/p) + O(log log n).
/// @param p  at most 1/3
/// @param n  1 to 1e300
Interval ternary_orders_left(double p, double n, double chance);

}  // namespace ramify
