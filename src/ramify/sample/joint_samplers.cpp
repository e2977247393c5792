#include "ramify/sample/sampler_of.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {

std::unique_ptr<TreeSampler> lean_sampler(const SamplerOrder& order) {
  return make_sampler_of<LeanFold>(order);
}

std::unique_ptr<TreeSampler> full_sampler(const SamplerOrder& order) {
  return make_sampler_of<FullFold>(order);
}

std::unique_ptr<TreeSampler> mean_counts_sampler(const SamplerOrder& order) {
  return make_sampler_of<MeanCounts>(order);
}

}  // namespace ramify::detail
