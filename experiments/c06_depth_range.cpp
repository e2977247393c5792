// C6, last parts (K96 2.5.2): "1/mu takes any value in [1/log 2, infinity)". mu = E h(X), h the entropy of a
// split, so that mu <= log 2. Of beta(a,a) 1/mu is continuous and falls as a grows, from beyond all bounds to
// 1/log 2: it takes every value above, and 1/log 2 itself for even splits alone.
#include <algorithm>
#include <cmath>

#include "depth_range.hpp"
#include <fmt/format.h>

#include "ramify/theory/depth_constant.hpp"

namespace ramify {
namespace {

constexpr int lowest_power = -16, highest_power = 20;
const double even_depth = 1 / std::log(2.0);

double depth_of(double a, double b) {
  return beta_depth({a, b}).value().value;
}

Statement of_range(std::size_t part, std::string text, Relation relation, std::string formula,
                   double theory) {
  return {fmt::format("C6.{}", part),
          std::move(text),
          "K96 2.5.2",
          "1/mu, a constant of the limit law",
          relation,
          std::move(formula),
          theory,
          {},
          std::nullopt};
}

Basis by_formula(double estimate, Interval interval, std::string method) {
  return {EvidenceKind::exact, Standing::proved, estimate, interval, Basis::none, std::move(method), ""};
}

Basis lowest_depth(const Evidence&) {
  constexpr double rounding = 1e-15;
  double lowest = HUGE_VAL;
  for (int a = lowest_power; a <= highest_power; a += 2)
    for (int b = a; b <= highest_power; b += 2)
      lowest = std::min(lowest, depth_of(std::ldexp(1, a), std::ldexp(1, b)));
  return by_formula(lowest, {lowest * (1 - rounding), lowest * (1 + rounding)},
                    fmt::format("mu = E h(X) <= log 2; least 1/mu of beta(a,b), a and b = 4^{}, ..., 4^{}",
                                lowest_power / 2, highest_power / 2));
}

/// The step from a to 2a by which 1/mu falls least.
Basis least_fall(const Evidence&) {
  constexpr double rounding = 1e-15;
  double worst = -HUGE_VAL;
  for (int a = lowest_power; a < highest_power; ++a)
    worst = std::max(worst, depth_of(std::ldexp(1, a + 1), std::ldexp(1, a + 1)) -
                                depth_of(std::ldexp(1, a), std::ldexp(1, a)));
  return by_formula(worst, {worst - rounding, worst + rounding},
                    fmt::format("1/mu of beta(2a,2a) less that of beta(a,a), a = 2^{}, ..., 2^{}",
                                lowest_power, highest_power - 1));
}

Basis infimum(const Evidence&) {
  const double a = std::ldexp(1, highest_power), reached = depth_of(a, a);
  return by_formula(reached, {even_depth, reached}, fmt::format("from 1/log 2 to 1/mu of beta({0},{0})", a));
}

Basis least_mean_log(const Evidence&) {
  const double a = std::ldexp(1, lowest_power), reached = 1 / depth_of(a, a);
  return by_formula(reached, {0, reached}, fmt::format("from 0 to mu of beta({0},{0})", a));
}

}  // namespace

std::vector<ClaimPart> depth_range_parts(std::size_t first) {
  Statement above = of_range(first, "1/mu is 1/log 2 at least", Relation::at_least, "1/log 2", even_depth);
  above.rivals = {{"1/h(0.4), splits 2 to 3", 1 / (-0.4 * std::log(0.4) - 0.6 * std::log(0.6))}};
  const Statement falls =
      of_range(first + 1, "1/mu of beta(a,a) falls as a grows", Relation::at_most, "0", 0);
  Statement least = of_range(first + 2, "the least 1/mu of beta(a,a) is 1/log 2, a -> infinity",
                             Relation::equals, "1/log 2", even_depth);
  least.rivals = {{"beta(1000,1000), some that are even enough", depth_of(1000, 1000)}};
  Statement most =
      of_range(first + 3, "mu of beta(a,a) -> 0, a -> 0: 1/mu has no bound", Relation::equals, "0", 0);
  most.rivals = {{"beta(0.01,0.01)", 1 / depth_of(0.01, 0.01)}};
  return {part_without_trees(std::move(above), lowest_depth), part_without_trees(falls, least_fall),
          part_without_trees(std::move(least), infimum), part_without_trees(std::move(most), least_mean_log)};
}

}  // namespace ramify
