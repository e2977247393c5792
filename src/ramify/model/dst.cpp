#include "ramify/model/dst.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {

Dst::Dst(double p) : p_(p) {
  require_domain(info(), std::array{p});
}

SplitCharacter Dst::character() const {
  const ConstantFraction fraction{p_, Scatter::binomial};
  return {fraction, p_ == 0.5, {.nanoseconds = 16}, reach_of(fraction)};
}

RealSplit Dst::real_split() const {
  return BinomialSplit{p_, 2, 1};
}

const ModelInfo& Dst::info() {
  static const ModelInfo info{
      .name = "dst",
      .parameters = {probability("p")},
      .largest_n = largest_size(),
      .description = "digital search tree: left ~ Bin(n-1,p); the thesis's binomial tree",
      .source = "A11, X16",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Dst(v[0])); }};
  return info;
}

}  // namespace ramify
