#pragma once

#include <memory>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

/// Samples trees of one model and measures them on the way. One virtual call for each tree, none for each
/// node. Holds the growing stack: use one for each thread. Tables are shared by all samplers cloned from one.
class TreeSampler {
 public:
  virtual ~TreeSampler() = default;

  /// What the method's pass knows of the tree of (key, replicate), n internal nodes, n at most the largest
  /// size ordered: depends on nothing else. Throws Interrupted when cancelled.
  virtual void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) = 0;

  /// A sampler for another thread.
  virtual std::unique_ptr<TreeSampler> clone() const = 0;
};

/// What a sampler is made for.
struct SamplerOrder {
  Model model;
  SamplingMethod method;
  Size largest_n;  ///< of the trees it will be asked for: what it is grafted from reaches as far
  const Cancellation* cancellation;  ///< must outlive the sampler
};

/// Computes the tables that the method grafts from: a second or so at most (graft_rule.hpp).
std::unique_ptr<TreeSampler> make_tree_sampler(const SamplerOrder& order);

}  // namespace ramify
