#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A quantity c + d/n + O(1/n^2) at n -> infinity, by its values at n = largest, /2, /4: two of them give c,
/// and what the other two give instead is the bound.
struct Extrapolated {
  double value, bound;
};
template <class ValueAt>
Extrapolated at_infinity(Size largest, ValueAt value_at) {
  constexpr double rounding = 1e-10;
  const double last = value_at(largest), middle = value_at(largest / 2), first = value_at(largest / 4);
  const double value = 2 * last - middle;
  return {value, std::abs(value - (2 * middle - first)) + rounding};
}

/// How that was made, of expected counts.
inline std::string counts_at_infinity(Size largest) {
  return fmt::format(
      "exact expected counts at n = {}, {}, {}, the term in 1/n taken off; bound: what two of them give less "
      "than the other two",
      largest / 4, largest / 2, largest);
}

}  // namespace ramify
