#include "ramify/shape/tropism.hpp"

#include <limits>

namespace ramify {
namespace {

constexpr double far_away = std::numeric_limits<double>::max();

using Values = std::span<const double>;

template <Tropism::Kind kind>
Tropism towards(Values v) {
  return {kind, v[0], {v[1], v[2], v[3]}};
}

template <Tropism::Kind kind>
Tropism by_share(Values v) {
  return {kind, v[0], {v[2], v[3], v[4]}, v[1]};
}

Tropism shifted(Values v) {
  return {Tropism::Kind::shift, 1, {v[0], v[1], v[2]}};
}

Tropism controlled(Values v) {
  return {Tropism::Kind::controller, v[0], {v[1], v[2], v[3]}, 0, v[4], v[5]};
}

}  // namespace

const std::vector<RuleInfo<Tropism>>& tropism_rules() {
  const RuleConstant strength{"strength", -1000, 1000}, x{"x", -far_away, far_away, 0},
      y{"y", -far_away, far_away, 0}, z{"z", -far_away, far_away, 0}, exponent{"exponent", 0, 10, 0.25};
  using enum Tropism::Kind;
  static const std::vector<RuleInfo<Tropism>> all{
      {"lean",
       {strength, x, y, z},
       "heading + strength (x,y,z), of length 1 again",
       "E22; Kruszewski 1996, 3.3.2",
       towards<lean>},
      {"torque",
       {strength, x, y, z},
       "turned to (x,y,z) by strength |heading x (x,y,z)| radians",
       "E29 with X56; Prusinkiewicz and Lindenmayer 1990, Figure 2.9",
       towards<torque>},
      {"pull",
       {{"strength", 0, 1000}, exponent, x, y, z},
       "angle to (x,y,z) over 1 + strength w, w = (nodes/nodes of the root)^exponent",
       "E30 (reconstruction); Devroye and Kruszewski 1995, Figure 10",
       by_share<pull>},
      {"bend",
       {{"strength", 0, 1000}, exponent, x, y, z},
       "angle to (x,y,z) over 1 + strength (1 - w)",
       "E31, E32 with X39; Devroye and Kruszewski 1995, Figures 11 and 12",
       by_share<bend>},
      {"shift", {x, y, z}, "the end moved by (x,y,z)", "E13; Aono and Kunii 1984", shifted},
      {"controller",
       {{"factor", -1000, 1000}, x, y, z, {"first_level", 0, 1e9, 0}, {"last_level", 0, 1e9, 1e9}},
       "the end moved by factor towards (x,y,z)",
       "E13 with X43; Aono and Kunii 1984",
       controlled},
  };
  return all;
}

}  // namespace ramify
