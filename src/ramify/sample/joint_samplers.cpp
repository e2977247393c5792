#include "ramify/sample/sampler_of.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {

std::unique_ptr<TreeSampler> orders_and_height_sampler(const SamplerOrder& order) {
  return make_sampler_of<OrdersAndHeight>(order);
}

std::unique_ptr<TreeSampler> orders_and_paths_sampler(const SamplerOrder& order) {
  return make_sampler_of<OrdersAndPaths>(order);
}

std::unique_ptr<TreeSampler> mean_counts_sampler(const SamplerOrder& order) {
  return make_sampler_of<MeanCounts>(order);
}

}  // namespace ramify::detail
