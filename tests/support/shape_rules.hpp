#pragma once

#include <string_view>
#include <vector>

#include "ramify/shape/place_limbs.hpp"

namespace ramify::test {

inline ExtentRule extent(std::string_view name, const std::vector<double>& constants) {
  return named_rule(extent_rules(), name, constants);
}

inline DeviationRule deviation(std::string_view name, const std::vector<double>& constants) {
  return named_rule(deviation_rules(), name, constants);
}

inline PlaneRule plane(std::string_view name, const std::vector<double>& constants) {
  return named_rule(plane_rules(), name, constants);
}

inline Tropism tropism(std::string_view name, const std::vector<double>& constants) {
  return named_rule(tropism_rules(), name, constants);
}

/// The form of a tree; what is random comes from one fixed stream.
inline Shape placed(const Tree& tree, const ShapeRules& rules) {
  Stream chance({18, 0}, 0, Lane::form);
  return place_limbs(tree, rules, chance, Cancellation());
}

}  // namespace ramify::test
