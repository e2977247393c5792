#pragma once

#include "ramify/model/model.hpp"

namespace ramify {

/// The computations of law/: one a class, except that StrahlerLaw, BalanceLaw and FillLevelLaw cost alike.
enum class LawKind { bounded, height, depth, node_sum, order_means, order_moments };

/// What a law with every size up to n takes, estimated before it is computed.
struct LawCost {
  double bytes;    ///< peak memory, right to a factor of 2
  double seconds;  ///< on one core of 2020s hardware, right to a factor of 3
};

/// With K = floor(log2(n+1)), D = 2K and w the mean number of values stored for one size (law_width.hpp):
///   bounded         3 (K+3) series of n+1 doubles
///   height          (12 w + 36) n bytes: a vector that grows holds one and a half times what is in it
///   depth           (8 w + 64) n bytes
///   node_sum        2 series
///   order_means     3 (K+3) + 2 (K+1) series
///   order_moments   those and D (2K+4) + D (D+1)/2 series
/// and the tables of the split rows, 24 to 240 n bytes by model. Time: an entry of a split row costs 4
/// to 40 ns to make, by model too, and 8 ns, w ns, w ns, 8 ns, 20 ns or 2 D^2 ns to use. O(1).
LawCost law_cost(const Model& model, LawKind kind, Size n);

/// The largest n of the model that costs at most these bytes and seconds, rounded down to two digits.
Size largest_affordable(const Model& model, LawKind kind, const LawCost& limit);

}  // namespace ramify
