#pragma once

#include <string_view>
#include <vector>

#include "ramify/core/find_named.hpp"
#include "ramify/shape/place_limbs.hpp"

namespace ramify::test {

template <class Rule>
Rule made_rule(const std::vector<RuleInfo<Rule>>& all, std::string_view name, std::vector<double> constants) {
  return find_named(all, &RuleInfo<Rule>::name, name, "rule").make(constants);
}

inline ExtentRule extent(std::string_view name, std::vector<double> constants) {
  return made_rule(extent_rules(), name, std::move(constants));
}

inline DeviationRule deviation(std::string_view name, std::vector<double> constants) {
  return made_rule(deviation_rules(), name, std::move(constants));
}

inline PlaneRule plane(std::string_view name, std::vector<double> constants) {
  return made_rule(plane_rules(), name, std::move(constants));
}

inline Tropism tropism(std::string_view name, std::vector<double> constants) {
  return made_rule(tropism_rules(), name, std::move(constants));
}

/// The form of a tree; what is random comes from one fixed stream.
inline Shape placed(const Tree& tree, const ShapeRules& rules) {
  Stream chance({18, 0}, 0, Lane::form);
  return place_limbs(tree, rules, chance, Cancellation());
}

}  // namespace ramify::test
