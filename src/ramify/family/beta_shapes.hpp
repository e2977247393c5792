#pragma once

#include <string_view>
#include <vector>

#include "ramify/family/family.hpp"

namespace ramify {

/// a and b of beta distributions, as they are searched.
inline std::vector<FamilyParameter> beta_shapes() {
  const auto shape = [](std::string_view name) -> FamilyParameter {
    return {name, {SearchScale::Kind::log_above, 0, 0}, 0.05, 500, {0.3, 1.5, 8}};
  };
  return {shape("a"), shape("b")};
}

/// A uniform split fraction grows binary search trees.
inline std::vector<NestedFamily> uniform_shapes() {
  return {{"bst", {1, 1}}};
}

/// The density of (a,a+1), taken with its mirror image, is that of (a,a): x^(a-1) (1-x)^(a-1) (x + 1-x).
inline constexpr std::string_view shapes_exchanged =
    "(a,b) and (b,a) grow mirror images: a <= b is given; (a,a) and (a,a+1) cannot be told apart";

}  // namespace ramify
