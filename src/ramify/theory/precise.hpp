#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace ramify {

/// 50 decimal digits. Constants of beta trees are differences of log-gammas and digammas that cancel up to
/// half their digits (beta(0.01,0.01), beta(1000,1000)); with 50 to lose from, a double comes out right.
using Precise =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// A value and a bound on its error.
struct Rounded {
  double value;
  double error;
};

/// The nearest double and a bound on its distance from the truth; nothing where fewer than 12 digits are
/// left.
///
/// @param value        > 0
/// @param cancelled    the largest magnitude that was subtracted on the way, in units of the smallest
/// difference kept;
///                     1 where nothing cancels
inline std::optional<Rounded> round_to_double(const Precise& value, const Precise& cancelled) {
  // Boost's special functions lose a few hundred units of the last of 50 digits; 1e4 leaves room for the
  // sums.
  const Precise relative = 1e4 * std::numeric_limits<Precise>::epsilon() * cancelled;
  const auto rounded = static_cast<double>(value);
  if (!(relative < 1e-12) || !(rounded > 0) || !std::isfinite(rounded)) return std::nullopt;
  const double half_ulp = std::numeric_limits<double>::epsilon() / 2;
  return Rounded{rounded, rounded * (half_ulp + static_cast<double>(relative))};
}

}  // namespace ramify
