#include "ramify/sample/tree_sampler.hpp"

#include <algorithm>
#include <array>

#include "ramify/core/contract.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify {
namespace {

struct PassSampler {
  FoldSet pass;
  std::unique_ptr<TreeSampler> (*make)(const SamplerOrder& order);
};

constexpr std::array<PassSampler, 11> samplers{{{orders_and_height, detail::orders_and_height_sampler},
                                                {orders_and_paths, detail::orders_and_paths_sampler},
                                                {all_but_indices, detail::all_but_indices_sampler},
                                                {all_folds, detail::all_folds_sampler},
                                                {orders_and_mean_counts, detail::mean_counts_sampler},
                                                {Folded::strahler, detail::strahler_sampler},
                                                {Folded::height, detail::height_sampler},
                                                {Folded::fill_level, detail::fill_level_sampler},
                                                {Folded::balance, detail::balance_sampler},
                                                {Folded::depth, detail::depth_sampler},
                                                {Folded::external_depth, detail::external_depth_sampler}}};

}  // namespace

std::unique_ptr<TreeSampler> make_tree_sampler(const SamplerOrder& order) {
  if (!order.model.is_split()) return detail::grown_sampler(order);
  const auto found = std::ranges::find(samplers, order.method.pass, &PassSampler::pass);
  RAMIFY_EXPECTS(found != samplers.end());
  return found->make(order);
}

}  // namespace ramify
