#include "ramify/theory/height_constant.hpp"

#include <utility>

#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/log_moment.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {
namespace {

/// Where the gap of the tangent vanishes: it rises for t > 0 from -mu at t = 1. Far below 1e30, unless
/// rounding has left nothing of it.
template <class Real>
std::pair<Real, Real> around_tangent(const LogMomentOf<Real>& log_moment) {
  Real low = 1, high = 2;
  while (log_moment.tangent_gap(high) <= 0 && high < 1e30) {
    low = high;
    high *= 2;
  }
  return {low, high};
}

/// The same, narrow: found in double precision, which takes a hundredth of the time, and checked.
std::optional<std::pair<Precise, Precise>> close_around_tangent(const BetaSplit& split,
                                                                const LogMoment& log_moment) {
  const LogMomentOf<double> rough(split);
  const auto [low, high] = around_tangent(rough);
  const auto brackets = [](const auto& tangent, const auto& below, const auto& above) {
    return tangent.tangent_gap(below) < 0 && tangent.tangent_gap(above) > 0;
  };
  if (!brackets(rough, low, high)) return std::nullopt;
  constexpr double slack = 1e-6;
  const Precise near = rough.tangent_point(low, high);
  const Precise below = near * (1 - slack), above = near * (1 + slack);
  return brackets(log_moment, below, above) ? std::optional(std::pair(below, above)) : std::nullopt;
}

}  // namespace

std::optional<Rounded> beta_height(const BetaSplit& split) {
  if (!LogMoment::reaches(split)) return std::nullopt;
  const LogMoment log_moment(split);
  const auto close = close_around_tangent(split, log_moment);
  const auto [low, high] = close ? *close : around_tangent(log_moment);
  const Precise t = log_moment.tangent_point(low, high);
  return round_to_double(-t / log_moment(t), log_moment.cancelled(t));
}

std::optional<Rounded> fixed_height(const BinarySplit& split) {
  return round_to_double(-1 / log1p(-split.smaller), 1);
}

std::optional<Constant> height_constant(const Model& model) {
  if (is_complete(model)) return complete_constant("height");
  if (const auto beta = BetaSplit::of(model))
    return make_constant("height", beta_height(*beta),
                         "min over t > 1 of t/(-log M(t)), M(t) = E[X^t + (1-X)^t]",
                         "Devroye 1986, Reed 2003; C7");
  if (const auto binary = BinarySplit::of(model))
    return make_constant("height", fixed_height(*binary), "1/log(1/max(p,1-p))", "Pittel 1985; C7");
  return std::nullopt;
}

}  // namespace ramify
