#pragma once

#include <span>
#include <vector>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// Mean length and radius of the streams of every order of a measured tree (B24), leaf order 0.
///
/// A stream is a maximal chain of nodes of one order; a node stands for the piece of branch above it. The
/// length of a stream is the sum of its pieces, its radius the mean over its pieces weighted by their length
/// (plain where no length is known or above 0). Means are over the streams of which the value is known; NaN
/// where there is none.
struct StreamGeometry {
  std::vector<double> mean_lengths;  ///< of orders 0..S; empty without lengths
  std::vector<double> mean_radii;    ///< likewise
};

/// @param lengths, radii  of every node in preorder, NaN where one has none; or empty
/// O(nodes) time, O(height + arity) memory.
StreamGeometry stream_geometry(const Tree& tree, std::span<const double> lengths,
                               std::span<const double> radii);

/// The ratio of neighbouring orders in a sequence of means x_0..x_S: Horton's second law says that they are
/// geometric in the order (C35; Horton 1945), x_(k+1) = R x_k. NaN where two orders are not known.
struct MeanRatios {
  double mean_ratio;  ///< mean of x_(k+1)/x_k over neighbouring orders that are known and above 0
  double regression;  ///< exp of the unweighted least-squares slope of log x_k on k
  double geometric;   ///< (x_last/x_first)^(1/(last - first)), the first and last order known
};

/// O(S).
MeanRatios mean_ratios(std::span<const double> means);

}  // namespace ramify
