#include "ramify/sample/sampler_of.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify::detail {

std::unique_ptr<TreeSampler> all_folds_sampler(const SamplerOrder& order) {
  return make_sampler_of<Stacked<IndexedFold>>(order);
}

}  // namespace ramify::detail
