#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ramify/statistic/last_node_depth.hpp"

namespace ramify {

/// Depth of an external node drawn uniformly from all (B23): from a node with m external nodes below it go to
/// a child with i of them with probability i/m, to the end; nodes on the way, both ends counted. 1 for n = 0.
/// Its mean over all draws is sackin/(n+1) + 1. @tparam Walk  as in LastNodeDepthOf
template <class Walk>
class ExternalDepthOf {
 public:
  struct Value {
    Size leaves;
    std::uint32_t depth;
    friend auto operator<=>(const Value&, const Value&) = default;
  };

  explicit ExternalDepthOf(Walk walk) : walk_(walk) {}

  Value external() const { return {1, 1}; }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, const Pair<Value>& below) {
    const Pair<Size> leaves{below[0].leaves, below[1].leaves};
    return joined(below, leaves, leaves[0] + leaves[1]);
  }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, std::span<const Value> below) {
    std::vector<Size> leaves;
    Size total = 0;
    for (const Value& value : below) total += leaves.emplace_back(value.leaves);
    return joined(below, leaves, total);
  }

  static constexpr WeightedWalk recurrence{1};

 private:
  template <class Values, class Leaves>
  Value joined(const Values& below, const Leaves& leaves, Size total) {
    return {total, 1 + below[walk_.choose(leaves, total)].depth};
  }

  Walk walk_;
};

using ExternalDepth = ExternalDepthOf<RandomWalk>;

}  // namespace ramify
