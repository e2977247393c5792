#include "ramify/core/error.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/sample/samplers.hpp"
#include "ramify/statistic/external_depth.hpp"
#include "ramify/statistic/last_node_depth.hpp"

namespace ramify::detail {
namespace {

/// Nodes on the walk from the root to the last node, or to an external node.
struct WalkKind {
  Lane lane;
  WeightedWalk walk;
  Size last;  ///< sizes up to this end the walk
  std::uint32_t TreeMeasures::* depth;
};
constexpr WalkKind to_last_node{Lane::walk, LastNodeDepth::recurrence, 1, &TreeMeasures::depth};
constexpr WalkKind to_external_node{Lane::external_walk, ExternalDepth::recurrence, 0,
                                    &TreeMeasures::external_depth};

/// Walks down, drawing the splits on its way only: O(depth).
template <class Law>
class WalkSampler final : public TreeSampler {
 public:
  WalkSampler(SplitTree<Law> grammar, WalkKind kind, const Cancellation* cancellation)
      : grammar_(std::move(grammar)), kind_(kind), cancellation_(cancellation) {}

  void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) override {
    Stream stream(key, replicate);
    RandomWalk walk(Stream(key, replicate, kind_.lane));
    measures = TreeMeasures();
    measures.size = n;
    std::uint32_t depth = n >= kind_.last ? 1 : 0;
    for (Size here = n; here > kind_.last; ++depth) {
      if (depth % nodes_between_looks == 0 && cancellation_->requested()) throw Interrupted();
      const Pair<Size> children = grammar_.children(here, stream);
      const Pair<Size> weights{children[0] + kind_.walk.weight_of_none,
                               children[1] + kind_.walk.weight_of_none};
      here = children[walk.choose(weights, weights[0] + weights[1])];
    }
    measures.*kind_.depth = depth;
  }

  std::unique_ptr<TreeSampler> clone() const override {
    return std::make_unique<WalkSampler>(grammar_, kind_, cancellation_);
  }

 private:
  static constexpr std::uint32_t nodes_between_looks = 1u << 20;

  SplitTree<Law> grammar_;
  WalkKind kind_;
  const Cancellation* cancellation_;
};

std::unique_ptr<TreeSampler> walk_sampler(const SamplerOrder& order, WalkKind kind) {
  return std::visit(
      [&]<class Law>(const Law& law) -> std::unique_ptr<TreeSampler> {
        return std::make_unique<WalkSampler<Law>>(SplitTree<Law>(law), kind, order.cancellation);
      },
      order.model.law());
}

}  // namespace

std::unique_ptr<TreeSampler> depth_sampler(const SamplerOrder& order) {
  return walk_sampler(order, to_last_node);
}

std::unique_ptr<TreeSampler> external_depth_sampler(const SamplerOrder& order) {
  return walk_sampler(order, to_external_node);
}

}  // namespace ramify::detail
