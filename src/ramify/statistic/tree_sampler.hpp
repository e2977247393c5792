#pragma once

#include <memory>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

/// Grows trees of one model and measures them on the way. One virtual call for each tree, none for each node.
/// Holds the growing stack: use one for each thread. Tables are shared by all samplers cloned from one.
class TreeSampler {
 public:
  virtual ~TreeSampler() = default;

  /// The tree of (key, replicate), n internal nodes: depends on nothing else. Throws Interrupted when
  /// cancelled.
  virtual void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) = 0;

  /// A sampler for another thread.
  virtual std::unique_ptr<TreeSampler> clone() const = 0;
};

/// @param full_pass     also last-node depth, fill level and balance
/// @param cancellation  must outlive the sampler
std::unique_ptr<TreeSampler> make_tree_sampler(const Model& model, bool full_pass,
                                               const Cancellation& cancellation);

}  // namespace ramify
