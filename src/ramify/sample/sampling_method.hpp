#pragma once

#include <string>

#include "ramify/model/registry.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// What is folded while a tree grows.
enum class Pass {
  lean,        ///< order, height, counts of nodes and streams
  full,        ///< all there is
  strahler,    ///< the order of the root alone
  height,      ///< alone
  fill_level,  ///< alone
  balance,     ///< alone
  depth,       ///< the walk to the last node: nothing is grown beside it
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

/// Subtrees up to this size are drawn from their exact law in a tree of size n; 0 where every node is grown.
///
/// A fixed function of model, method and n, never of the clock or the machine. Trees below n = 1024 are grown
/// whole. One statistic: the power of two at or below 8 sqrt(n), so that a table costs no more than a few
/// trees, and no more than a limit at which tables take half a second. Several: 16 to 28 in the lean pass, 12
/// in the full one, where the outcomes are still few (3,000 to 135,000).
Size graft_size(const Model& model, SamplingMethod method, Size n);

/// About as many nodes as are grown for a tree of size n: n, or n over half the graft size; for catalan n
/// over the root of pi times it; for the walk its length.
double grown_nodes(const Model& model, SamplingMethod method, Size n);

/// "every node is grown", "strahler of subtrees up to n = 16384 drawn from the exact law".
std::string describe(const Model& model, SamplingMethod method, Size n);

}  // namespace ramify
