#pragma once

#include "ramify/model/model.hpp"
#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// What is computed, of the counts of orders in particular: their means alone, or all covariances.
struct LawWork {
  Recurrence recurrence;
  bool means_alone = false;
};

/// What a law with every size up to n takes, estimated before it is computed.
struct LawCost {
  double bytes;    ///< peak memory, right to a factor of 2
  double seconds;  ///< on one core of 2020s hardware, right to a factor of 3
};

/// With K = floor(log2(n+1)), D = 2K and w the mean number of values stored for one size (law_width.hpp):
///   BoundedJoin    3 (K+3) series of n+1 doubles
///   LongestPath    (13 w + 36) n bytes: a vector that grows holds one and a half times what is in it
///   WeightedWalk   (8 w + 64) n bytes
///   NodeSum        2 series
///   CountOfOrder   3 (K+3) + 2 (K+1) series for the means, and D (2K+4) + D (D+1)/2 for the covariances
/// and the tables of the split rows, 24 to 240 n bytes by model. Time: an entry of a split row costs 4
/// to 40 ns to make, by model too, and 8 ns, w ns, w ns, 8 ns, 20 ns or 2 D^2 ns to use. O(1).
LawCost law_cost(const Model& model, const LawWork& work, Size n);

/// The largest n of the model that costs at most these bytes and seconds, rounded down to two digits.
Size largest_affordable(const Model& model, const LawWork& work, const LawCost& limit);

}  // namespace ramify
