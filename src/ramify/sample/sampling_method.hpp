#pragma once

#include "ramify/statistic/registry.hpp"

namespace ramify {

/// What is folded while a tree grows.
enum class Pass {
  lean,            ///< order, height, counts of nodes and streams
  full,            ///< those, depth, fill level and balance
  all,             ///< all there is; every node is grown
  strahler,        ///< the order of the root alone
  height,          ///< alone
  fill_level,      ///< alone
  balance,         ///< alone
  depth,           ///< the walk to the last node: nothing is grown beside it
  external_depth,  ///< the walk to an external node
  mean_counts,     ///< order, and counts of which the small subtrees are averaged (mean_counts.hpp)
};

/// How the trees of a run are sampled: a fixed function of the statistics that are asked for.
struct SamplingMethod {
  Pass pass;
  bool graft;  ///< false: every node is grown, in the lean, the full or the last pass

  friend bool operator==(const SamplingMethod&, const SamplingMethod&) = default;
};

inline constexpr SamplingMethod grow_lean{Pass::lean, false}, grow_full{Pass::full, false},
    grow_all{Pass::all, false};

/// One statistic alone (and the size) has a pass of its own; several share the lean or the full one. Without
/// grafts there are those two.
SamplingMethod sampling_method(const StatisticSet& statistics, bool graft);

/// What a pass folds: "strahler", "order, height and counts".
std::string_view describe(Pass pass);

}  // namespace ramify
