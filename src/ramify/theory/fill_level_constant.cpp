#include "ramify/theory/fill_level_constant.hpp"

#include <algorithm>

#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/log_moment.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {
namespace {

std::optional<Constant> fill_level_of_beta(const BetaSplit& split) {
  if (!LogMoment::reaches(split)) return std::nullopt;
  const LogMoment log_moment(split);
  // The gap falls for t < 0, from infinity at the pole -min(a,b) to -log 2 at 0.
  const Precise pole = -Precise(std::min(split.a, split.b));
  Precise from_pole = -pole / 2, high = 0;
  while (log_moment.tangent_gap(pole + from_pole) <= 0) {
    high = pole + from_pole;
    from_pole /= 2;
  }
  const Precise t = log_moment.tangent_point(pole + from_pole, high);
  return make_constant("fill_level", round_to_double(-t / log_moment(t), log_moment.cancelled(t)),
                       "max over t < 0 of (-t)/log M(t), M(t) = E[X^t + (1-X)^t]", "Devroye 1986; C18");
}

std::optional<Constant> fill_level_of_binary(const BinarySplit& split, const char* source) {
  return make_constant("fill_level", round_to_double(-1 / log(split.smaller), 1), "1/log(1/min(p,1-p))",
                       source);
}

}  // namespace

std::optional<Constant> fill_level_constant(const Model& model) {
  if (is_complete(model)) return complete_constant("fill_level");
  if (const auto beta = BetaSplit::of(model)) return fill_level_of_beta(*beta);
  const auto binary = BinarySplit::of_smaller_path(model);
  if (!binary) return std::nullopt;
  const bool fixed = binary->scatter == Scatter::none;
  return fill_level_of_binary(*binary,
                              fixed ? "the path of smaller children; C11" : "Kruszewski 1996, cor. B.2; C17");
}

}  // namespace ramify
