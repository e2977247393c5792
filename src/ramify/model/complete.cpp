#include "ramify/model/complete.hpp"

#include "ramify/model/model_info.hpp"

namespace ramify {

SplitCharacter Complete::character() const {
  return {PerfectFraction(), false, {}, reach_of(ConstantFraction{0.5, Scatter::none})};
}

const ModelInfo& Complete::info() {
  static const ModelInfo info{
      .name = "complete",
      .description = "complete tree: every level full but the last, which is filled from the left",
      .source = "A3; Knuth 1997, 2.3.4.5",
      .make = [](std::span<const double>) -> AnyModel { return AnySplitLaw(Complete()); }};
  return info;
}

}  // namespace ramify
