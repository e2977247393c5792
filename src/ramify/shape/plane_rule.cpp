#include "ramify/shape/plane_rule.hpp"

#include <cstdint>
#include <utility>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double whole_turn = 360;

template <PlaneRule::Kind kind>
PlaneRule plane(std::span<const double> constants) {
  return {kind, constants.empty() ? whole_turn : constants[0]};
}

}  // namespace

const std::vector<RuleInfo<PlaneRule>>& plane_rules() {
  using enum PlaneRule::Kind;
  const RuleConstant angle{"angle", -whole_turn, whole_turn};
  static const std::vector<RuleInfo<PlaneRule>> all{
      {"carried",
       {angle},
       "the mother's plane, turned by angle",
       "E1, E5; Kruszewski 1996, 2.3.4",
       plane<carried>},
      {"horizontal",
       {angle},
       "on the trunk the mother's plane, turned by angle; elsewhere level with the ground",
       "E11 with X28; Honda 1971",
       plane<horizontal>},
      {"gradient",
       {angle},
       "level with the ground, turned by angle for every level from the root",
       "E12 with X44; Aono and Kunii 1984",
       plane<gradient>},
      {"random", {}, "the mother's plane, turned by a uniform angle", "E20, E26", plane<random>},
  };
  return all;
}

double schimper_braun_angle(unsigned i) {
  RAMIFY_EXPECTS(i >= 1 && i <= 40);
  std::uint64_t fibonacci = 1, next = 1;
  for (unsigned k = 1; k < i; ++k) fibonacci = std::exchange(next, fibonacci + next);
  return whole_turn * static_cast<double>(fibonacci) / static_cast<double>(fibonacci + next);
}

}  // namespace ramify
