#pragma once

#include "ramify/statistic/registry.hpp"

namespace ramify {

/// What is folded while a tree grows.
enum class Pass {
  lean,         ///< order, height, counts of nodes and streams
  full,         ///< all there is
  strahler,     ///< the order of the root alone
  height,       ///< alone
  fill_level,   ///< alone
  balance,      ///< alone
  depth,        ///< the walk to the last node: nothing is grown beside it
  mean_counts,  ///< order, and counts of which the small subtrees are averaged (mean_counts.hpp)
};

/// How the trees of a run are sampled: a fixed function of the statistics that are asked for.
struct SamplingMethod {
  Pass pass;
  bool graft;  ///< false: every node is grown, in the lean or the full pass

  friend bool operator==(const SamplingMethod&, const SamplingMethod&) = default;
};

inline constexpr SamplingMethod grow_lean{Pass::lean, false}, grow_full{Pass::full, false};

/// One statistic alone (and the size) has a pass of its own; several share the lean or the full one. Without
/// grafts there are those two.
SamplingMethod sampling_method(const StatisticSet& statistics, bool graft);

/// What a pass folds: "strahler", "order, height and counts".
std::string_view describe(Pass pass);

}  // namespace ramify
