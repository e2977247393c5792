#include "ramify/model/split_character.hpp"

#include <algorithm>

namespace ramify {

double depth_exponent(const SplitFraction& fraction) {
  if (const auto* beta = std::get_if<BetaFraction>(&fraction))
    return std::max(0.0, -std::min(beta->a, beta->b));
  const auto* none = std::get_if<NoFraction>(&fraction);
  return none != nullptr ? none->depth_exponent : 0;
}

bool splits_in_one_way(const SplitFraction& fraction) {
  if (const auto* constant = std::get_if<ConstantFraction>(&fraction))
    return constant->scatter == Scatter::none;
  return std::holds_alternative<PerfectFraction>(fraction) || depth_exponent(fraction) == 1;
}

LawReach reach_of(const BetaFraction& fraction) {
  const bool wide = std::min(fraction.a, fraction.b) < 0.1;  // chains: depths spread over n/2 values
  return {wide ? Size{2048} : Size{4096}, 2048};  // 2.5 s at a = b = 0.01, 2.2 at 0.1, 0.5 at 2; 0.7
}

LawReach reach_of(const ConstantFraction& fraction) {
  const bool lopsided =
      std::min(fraction.p, 1 - fraction.p) < 0.01;     // depths spread over thousands of values
  return {lopsided ? Size{4096} : Size{16384}, 4096};  // 0.6-1.4 s, 0.8; split 0.1, 0.2
}

}  // namespace ramify
