#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ramify/theory/constant.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// The row of a constant whose value was found; nothing where none was.
inline std::optional<Constant> make_constant(std::string_view name, const std::optional<Rounded>& found,
                                             std::string_view formula, std::string_view source) {
  if (!found) return std::nullopt;
  return Constant{std::string(name), found->value, found->error, std::string(formula), std::string(source)};
}

}  // namespace ramify
