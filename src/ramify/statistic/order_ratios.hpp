#pragma once

#include <cstdint>
#include <span>

namespace ramify {

/// The bifurcation ratio of one tree by three estimators; NaN where the tree has no order above its leaves.
///
/// counts: the number of nodes, or of streams, of orders 0..S of one tree, S = counts.size()-1, all > 0. Say
/// which.
struct OrderRatios {
  double mean_ratio;  ///< (1/S) sum of N_k/N_(k+1), k = 0..S-1 (the thesis, 3.1.2, B11a)
  double regression;  ///< exp of minus the unweighted least-squares slope of log N_k on k, orders 0..S (B11c)
  double geometric;   ///< (N_0/N_S)^(1/S)
};

/// O(S).
OrderRatios order_ratios(std::span<const std::uint64_t> counts);

}  // namespace ramify
