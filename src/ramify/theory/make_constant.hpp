#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "ramify/theory/constant.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// What lies between a double and the text that it is printed as, the shortest that reads back as it.
inline double printing_error(double value) {
  return static_cast<double>(abs(Precise(fmt::format("{}", value)) - Precise(value)));
}

/// A bound that still is one where ten of its digits are printed; nothing is added to what is exact.
inline double printed_bound(const Rounded& found) {
  return found.error == 0 ? 0 : (found.error + printing_error(found.value)) * (1 + 1e-9);
}

/// The row of a constant whose value was found; nothing where none was.
inline std::optional<Constant> make_constant(std::string_view name, const std::optional<Rounded>& found,
                                             std::string_view formula, std::string_view source) {
  if (!found) return std::nullopt;
  return Constant{std::string(name), found->value, printed_bound(*found), std::string(formula),
                  std::string(source)};
}

}  // namespace ramify
