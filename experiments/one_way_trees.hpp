#pragma once

#include <cstdint>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// S of the tree of every size 0..largest_n of a model whose sizes split in one way (complete, chain,
/// split(x)), leaf order 0. O(largest_n). Throws Interrupted.
std::vector<std::uint8_t> one_way_orders(const Model& model, Size largest_n,
                                         const Cancellation& cancellation);

/// The counts of one such tree, of orders 0..S.
struct OneWayCounts {
  std::vector<std::uint64_t> nodes, streams;
};

/// Of the tree of size n. Subtrees of one size are one tree: time and memory O(number of sizes), of split(x)
/// some log(n)^2, so that n may be as large as the model can draw.
OneWayCounts one_way_counts(const Model& model, Size n);

}  // namespace ramify
