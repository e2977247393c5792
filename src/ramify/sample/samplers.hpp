#pragma once

#include "ramify/sample/tree_sampler.hpp"

/// One sampler for each pass, compiled apart: each is a growing loop for every split law.
namespace ramify::detail {

std::unique_ptr<TreeSampler> orders_and_height_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> orders_and_paths_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> all_but_indices_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> all_folds_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> grown_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> mean_counts_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> strahler_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> height_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> fill_level_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> balance_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> depth_sampler(const SamplerOrder& order);
std::unique_ptr<TreeSampler> external_depth_sampler(const SamplerOrder& order);

}  // namespace ramify::detail
