#include "ramify/model/bst.hpp"

#include <cmath>

#include "ramify/model/model_info.hpp"

namespace ramify {

SplitCharacter Bst::character() const {
  return {BetaFraction{1, 1, Scatter::none}, true, {}, {8192, 2048}};  // 2.4 s, 0.6
}

RealSplit Bst::real_split() const {
  return SmoothSplit{[](double left, double right) { return -std::log(left + right - 1); }, true};
}

const ModelInfo& Bst::info() {
  static const ModelInfo info{.name = "bst",
                              .description = "random binary search tree: left uniform on 0..n-1",
                              .source = "A14; Devroye 1986",
                              .make = [](std::span<const double>) -> AnyModel { return AnySplitLaw(Bst()); }};
  return info;
}

}  // namespace ramify
