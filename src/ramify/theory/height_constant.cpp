#include "ramify/theory/height_constant.hpp"

#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/log_moment.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {
namespace {

std::optional<Constant> height_of_beta(const BetaSplit& split) {
  if (!LogMoment::reaches(split)) return std::nullopt;
  const LogMoment log_moment(split);
  // The gap rises for t > 0 from -mu at t = 1.
  Precise low = 1, high = 2;
  while (log_moment.tangent_gap(high) <= 0) {
    low = high;
    high *= 2;
  }
  const Precise t = log_moment.tangent_point(low, high);
  return make_constant("height", round_to_double(-t / log_moment(t), log_moment.cancelled(t)),
                       "min over t > 1 of t/(-log M(t)), M(t) = E[X^t + (1-X)^t]",
                       "Devroye 1986, Reed 2003; C7");
}

std::optional<Constant> height_of_binary(const BinarySplit& split) {
  return make_constant("height", round_to_double(-1 / log1p(-split.smaller), 1), "1/log(1/max(p,1-p))",
                       "Pittel 1985; C7");
}

}  // namespace

std::optional<Constant> height_constant(const Model& model) {
  if (is_complete(model)) return complete_constant("height");
  if (const auto beta = BetaSplit::of(model)) return height_of_beta(*beta);
  if (const auto binary = BinarySplit::of(model)) return height_of_binary(*binary);
  return std::nullopt;
}

}  // namespace ramify
