#include "ramify/model/chain.hpp"

#include "ramify/model/model_info.hpp"

namespace ramify {

WeightWindow Chain::window(Size n, double) const {
  std::vector<double> weights(n, 0.0);
  weights.front() += 0.5;
  weights.back() += 0.5;
  return {0, std::move(weights)};
}

SplitCharacter Chain::character() const {
  return {NoFraction{1}, true, {}, {16384, 4096}};  // one entry a row, one value a size
}

const ModelInfo& Chain::info() {
  static const ModelInfo info{
      .name = "chain",
      .description = "left = 0 or n-1 by the toss of a coin",
      .source = "A4; Viennot 1990",
      .make = [](std::span<const double>) -> AnyModel { return AnySplitLaw(Chain()); }};
  return info;
}

}  // namespace ramify
