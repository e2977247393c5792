#include "ramify/sample/sampler_of.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {

std::unique_ptr<TreeSampler> all_but_indices_sampler(const SamplerOrder& order) {
  return make_sampler_of<Stacked<AllFold>>(order);
}

}  // namespace ramify::detail
