#include "ramify/statistic/tree_sampler.hpp"

#include "ramify/model/split_tree.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/joint.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/tree/grow.hpp"

namespace ramify {
namespace {

// Larger values first: the lean pack is 8 bytes, the full one 12.
using LeanFold = Joint<Height, HortonStrahler>;
using FullFold = Joint<LastNodeDepth, Height, HortonStrahler, FillLevel, Balance>;

template <class F>
F make_fold(StreamKey key, std::uint64_t replicate) {
  if constexpr (std::is_same_v<F, LeanFold>) {
    return F();
  } else {
    return F(LastNodeDepth(Stream(key, replicate, Lane::walk)), Height(), HortonStrahler(), FillLevel(),
             Balance());
  }
}

void record(const LeanFold::Value& root, TreeMeasures& measures) {
  measures.height = get<0>(root);
  measures.strahler = get<1>(root);
}

void record(const FullFold::Value& root, TreeMeasures& measures) {
  measures.depth = get<0>(root);
  measures.height = get<1>(root);
  measures.strahler = get<2>(root);
  measures.fill_level = get<3>(root);
  measures.balance = get<4>(root);
}

template <class Law, class F>
class SamplerOf final : public TreeSampler {
 public:
  SamplerOf(SplitTree<Law> grammar, const Cancellation& cancellation)
      : grammar_(std::move(grammar)), cancellation_(&cancellation), grower_(cancellation) {}

  void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) override {
    Stream stream(key, replicate);
    F fold = make_fold<F>(key, replicate);
    measures = TreeMeasures();
    record(grower_(grammar_, n, stream, fold), measures);
    const auto& orders = fold.template get<HortonStrahler>();
    measures.nodes = orders.nodes();
    measures.streams = orders.streams();
    for (std::size_t k = 1; k < HortonStrahler::orders; ++k) measures.size += measures.nodes[k];
  }

  std::unique_ptr<TreeSampler> clone() const override {
    return std::make_unique<SamplerOf>(grammar_, *cancellation_);
  }

 private:
  SplitTree<Law> grammar_;
  const Cancellation* cancellation_;
  Grower<SplitTree<Law>, F, Stream> grower_;
};

}  // namespace

std::unique_ptr<TreeSampler> make_tree_sampler(const Model& model, bool full_pass,
                                               const Cancellation& cancellation) {
  return std::visit(
      [&]<class Law>(const Law& law) -> std::unique_ptr<TreeSampler> {
        SplitTree<Law> grammar(law);
        if (full_pass) return std::make_unique<SamplerOf<Law, FullFold>>(std::move(grammar), cancellation);
        return std::make_unique<SamplerOf<Law, LeanFold>>(std::move(grammar), cancellation);
      },
      model.law());
}

}  // namespace ramify
