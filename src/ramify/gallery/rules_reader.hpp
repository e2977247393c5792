#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ramify/config/toml_value.hpp"
#include "ramify/shape/shape_rules.hpp"

namespace ramify::detail {

/// The value of a key, or nothing.
using FindKey = std::function<std::optional<TomlValue>(std::string_view key)>;

/// The value of a key that a preset must have; throws Error where it has not. @param why  it must
TomlValue require(const FindKey& find, std::string_view file, std::string_view key, std::string_view why);

/// A number within bounds. Throws Error with the place.
/// @param of  of what the bounds are, as the message begins: "of the rule constant "
double read_between(const TomlValue& value, double least, double most, const Expected& expected,
                    std::string_view of = "");

/// The rules of a panel from its keys radius, length, deviation, plane, tropism, arrangement, azimuths,
/// joint, main, mirrors and foreshortens. Throws Error with the place.
ShapeRules read_rules(std::string_view file, const FindKey& find);

}  // namespace ramify::detail
