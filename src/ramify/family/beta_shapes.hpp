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

inline constexpr std::string_view shapes_exchanged = "(a,b) and (b,a) grow mirror images: a <= b is given";

}  // namespace ramify
