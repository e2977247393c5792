#include "ramify/theory/constants.hpp"

#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/fill_level_constant.hpp"
#include "ramify/theory/height_constant.hpp"
#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/split_variance.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace ramify {

std::vector<Constant> constants(const Model& model) {
  std::vector<Constant> known;
  for (const auto constant :
       {depth_constant, height_constant, strahler_constant, fill_level_constant, split_mean, split_variance})
    if (auto found = constant(model)) known.push_back(*std::move(found));
  return known;
}

}  // namespace ramify
