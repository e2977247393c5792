#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "ramify/config/toml_value.hpp"
#include "ramify/shape/shape_rules.hpp"

namespace ramify::detail {

/// The value of a key, or nothing.
using FindKey = std::function<std::optional<TomlValue>(std::string_view key)>;

/// The rules of a panel from its keys radius, length, deviation, plane, tropism, arrangement, azimuths,
/// joint, main, mirrors and foreshortens. Throws Error with the place.
ShapeRules read_rules(std::string_view file, const FindKey& find);

}  // namespace ramify::detail
