#include "ramify/sample/tree_sampler.hpp"

#include "ramify/core/contract.hpp"
#include "ramify/sample/samplers.hpp"

namespace ramify {

std::unique_ptr<TreeSampler> make_tree_sampler(const SamplerOrder& order) {
  if (!order.model.is_split()) return detail::grown_sampler(order);
  switch (order.method.pass) {
    case Pass::lean:
      return detail::lean_sampler(order);
    case Pass::full:
      return detail::full_sampler(order);
    case Pass::all:
      return detail::all_sampler(order);
    case Pass::external_depth:
      return detail::external_depth_sampler(order);
    case Pass::mean_counts:
      return detail::mean_counts_sampler(order);
    case Pass::strahler:
      return detail::strahler_sampler(order);
    case Pass::height:
      return detail::height_sampler(order);
    case Pass::fill_level:
      return detail::fill_level_sampler(order);
    case Pass::balance:
      return detail::balance_sampler(order);
    case Pass::depth:
      return detail::depth_sampler(order);
  }
  RAMIFY_EXPECTS(false);
  return nullptr;
}

}  // namespace ramify
