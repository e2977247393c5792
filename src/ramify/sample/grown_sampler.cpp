#include "ramify/sample/measure_tree.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {
namespace {

/// Trees that are no split trees: grown, stored, and measured whole.
class GrownSampler final : public TreeSampler {
 public:
  explicit GrownSampler(SamplerOrder order) : order_(std::move(order)) {}

  void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) override {
    Stream stream(key, replicate);
    const Tree tree = order_.model.grown().grow(n, stream, *order_.cancellation);
    measures = measure_tree(tree, key, replicate, order_.method.pass);
  }

  std::unique_ptr<TreeSampler> clone() const override { return std::make_unique<GrownSampler>(order_); }

 private:
  SamplerOrder order_;
};

}  // namespace

std::unique_ptr<TreeSampler> grown_sampler(const SamplerOrder& order) {
  return std::make_unique<GrownSampler>(order);
}

}  // namespace ramify::detail
