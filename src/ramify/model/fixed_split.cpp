#include "ramify/model/fixed_split.hpp"

#include <array>

#include "ramify/model/model_info.hpp"

namespace ramify {
namespace {

double checked_fraction(double x) {
  require_domain(FixedSplit::info(), std::array{x});
  return x;
}

}  // namespace

FixedSplit::FixedSplit(double x) : x_(checked_fraction(x)), exact_(Rational::of(x)) {}

FixedSplit::FixedSplit(double x, const Rational& exact) : x_(checked_fraction(x)), exact_(exact) {}

SplitCharacter FixedSplit::character() const {
  const ConstantFraction fraction{x_, Scatter::none};
  return {fraction, false, {}, reach_of(fraction)};
}

const ModelInfo& FixedSplit::info() {
  static const ModelInfo info{
      .name = "split",
      .parameters = {probability("x")},
      .largest_n = largest_size(),
      .description = "deterministic: left = floor(nx)",
      .source = "A6; Kruszewski 1996, 2.5.1",
      .make = [](std::span<const double> v, std::span<const Rational> exact) -> AnyModel {
        return AnySplitLaw(FixedSplit(v[0], exact[0]));
      }};
  return info;
}

}  // namespace ramify
