#include "ramify/theory/constants.hpp"

#include <utility>

#include "ramify/theory/balance_constant.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/fill_level_constant.hpp"
#include "ramify/theory/height_constant.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"
#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/split_variance.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {

std::vector<Constant> constants(const Model& model) {
  if (!model.is_split()) return {};
  std::vector<Constant> known;
  const auto list = [&known](std::optional<Constant> constant) {
    if (constant) known.push_back(*std::move(constant));
  };
  const auto ratio = horton_ratio_constant(model);  // the dearest, and strahler follows from it
  list(depth_constant(model));
  list(height_constant(model));
  list(strahler_constant(model, ratio));
  list(ratio);
  list(fill_level_constant(model));
  list(balance_constant(model));
  list(split_mean(model));
  list(split_variance(model));
  return known;
}

}  // namespace ramify
