#include "ramify/core/error.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/sample/samplers.hpp"
#include "ramify/statistic/last_node_depth.hpp"

namespace ramify::detail {
namespace {

/// Walks from the root to the last node, drawing the splits on its way only: O(depth).
template <class Law>
class DepthSampler final : public TreeSampler {
 public:
  DepthSampler(SplitTree<Law> grammar, const Cancellation* cancellation)
      : grammar_(std::move(grammar)), cancellation_(cancellation) {}

  void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) override {
    Stream stream(key, replicate);
    RandomWalk walk(Stream(key, replicate, Lane::walk));
    measures = TreeMeasures();
    measures.size = n;
    measures.depth = n > 0 ? 1 : 0;
    for (Size here = n; here >= 2; ++measures.depth) {
      if (measures.depth % nodes_between_looks == 0 && cancellation_->requested()) throw Interrupted();
      const Pair<Size> children = grammar_.children(here, stream);
      here = children[walk.choose(children, here - 1)];
    }
  }

  std::unique_ptr<TreeSampler> clone() const override {
    return std::make_unique<DepthSampler>(grammar_, cancellation_);
  }

 private:
  static constexpr std::uint32_t nodes_between_looks = 1u << 20;

  SplitTree<Law> grammar_;
  const Cancellation* cancellation_;
};

}  // namespace

std::unique_ptr<TreeSampler> depth_sampler(const SamplerOrder& order) {
  return std::visit(
      [&]<class Law>(const Law& law) -> std::unique_ptr<TreeSampler> {
        return std::make_unique<DepthSampler<Law>>(SplitTree<Law>(law), order.cancellation);
      },
      order.model.law());
}

}  // namespace ramify::detail
