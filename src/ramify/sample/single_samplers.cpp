#include "ramify/sample/sampler_of.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {

std::unique_ptr<TreeSampler> strahler_sampler(const SamplerOrder& order) {
  return make_sampler_of<Strahler>(order);
}

std::unique_ptr<TreeSampler> height_sampler(const SamplerOrder& order) {
  return make_sampler_of<Height>(order);
}

std::unique_ptr<TreeSampler> fill_level_sampler(const SamplerOrder& order) {
  return make_sampler_of<FillLevel>(order);
}

std::unique_ptr<TreeSampler> balance_sampler(const SamplerOrder& order) {
  return make_sampler_of<Balance>(order);
}

}  // namespace ramify::detail
