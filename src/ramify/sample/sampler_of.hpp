#pragma once

#include <memory>
#include <optional>

#include "ramify/model/split_tree.hpp"
#include "ramify/sample/graft_rule.hpp"
#include "ramify/sample/graft_tables.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/tree/grow.hpp"

namespace ramify::detail {

/// Grows trees of one split law, folds them with F and grafts what GraftRule says.
template <class Law, class F>
class SamplerOf final : public TreeSampler {
 public:
  SamplerOf(const Law& law, const SamplerOrder& order)
      : SamplerOf(std::make_shared<const Shared>(order, law)) {}

  void sample(Size n, StreamKey key, std::uint64_t replicate, TreeMeasures& measures) override {
    Stream stream(key, replicate);
    F fold = make_fold<F>(key, replicate);
    measures = TreeMeasures();
    measures.size = n;
    record(fold, root_value(n, stream, fold), measures);
  }

  std::unique_ptr<TreeSampler> clone() const override {
    return std::unique_ptr<TreeSampler>(new SamplerOf(shared_));
  }

 private:
  /// What is grafted, and how the sizes above it are drawn.
  struct Grafting {
    // Small sizes are grafted, those above them are what is left to draw: a larger table pays than for trees
    // that are grown whole.
    static constexpr Size table_size = 256;

    SplitTree<Law> grammar;
    std::shared_ptr<const GraftTableOf<F>> table;
  };

  /// What all clones read.
  struct Shared {
    Shared(const SamplerOrder& order, const Law& law)
        : rule(order.model, order.method), cancellation(order.cancellation), grammar(law) {
      if constexpr (is_grafted<F>) {
        if (const Size largest = rule.size(order.largest_n); largest > 0)
          grafting = {SplitTree<Law>(law, Grafting::table_size),
                      make_graft_table<F>(order.model, largest, *order.cancellation)};
      }
    }

    GraftRule rule;
    const Cancellation* cancellation;
    SplitTree<Law> grammar;            ///< of trees that are grown whole
    std::optional<Grafting> grafting;  ///< nothing where no tree is large enough
  };

  explicit SamplerOf(std::shared_ptr<const Shared> shared)
      : shared_(std::move(shared)), grower_(*shared_->cancellation) {}

  typename F::Value root_value(Size n, Stream& stream, F& fold) {
    if constexpr (is_grafted<F>) {
      if (const Size grafted = shared_->rule.size(n); grafted > 0) {
        const Grafting& grafting = *shared_->grafting;
        return grower_(grafting.grammar, n, stream, fold, Graft(*grafting.table, grafted));
      }
    }
    return grower_(shared_->grammar, n, stream, fold);
  }

  std::shared_ptr<const Shared> shared_;
  Grower<SplitTree<Law>, F, Stream> grower_;
};

/// The sampler of an order's model, whatever its law.
template <class F>
std::unique_ptr<TreeSampler> make_sampler_of(const SamplerOrder& order) {
  return std::visit(
      [&]<class Law>(const Law& law) -> std::unique_ptr<TreeSampler> {
        return std::make_unique<SamplerOf<Law, F>>(law, order);
      },
      order.model.law());
}

}  // namespace ramify::detail
