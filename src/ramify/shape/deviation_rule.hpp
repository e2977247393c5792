#pragma once

#include <functional>
#include <span>
#include <vector>

#include "ramify/random/stream.hpp"
#include "ramify/shape/node_facts.hpp"
#include "ramify/shape/rule_info.hpp"

namespace ramify {

/// What a rule for an angle is given: a fork whose radii are known.
struct ForkQuestion {
  const NodeFacts& mother;
  std::span<const NodeFacts> children;
  Stream& chance;
};

/// By how many degrees a child turns away from the mother's axis.
using DeviationRule = std::function<double(const ForkQuestion&, std::size_t child)>;

/// All rules for deviations, in the order they are listed.
const std::vector<RuleInfo<DeviationRule>>& deviation_rules();

/// Murray's angle (1926), in degrees: arccos((R^4 + r^4 - s^4)/(2 R^2 r^2)) of a branch of radius r beside
/// one of radius s on a mother of radius R. Throws Error where the argument is no cosine, as when radii grow
/// by an exponent below 2 (X60). K96 2.3.3.
double murray_angle(double mother, double child, double sibling);

/// How much of the way from its lowest to its highest angle a branch of GMT4 has at tau, 0 at the foot and 1
/// at the top, in one of the five categories; closed forms that behave as the source's words say, for its
/// equations do not (X45). @param peak  of the fifth category, above 0 and at most 1/2. E15; Aono and Kunii
/// 1984, Table 3.
double level_share(int category, double tau, double peak);

}  // namespace ramify
