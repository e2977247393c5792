#pragma once

#include <cstdint>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

namespace ramify {

/// The root of a continuous function between two points where it has different signs, to the last few bits.
template <class Function>
double root_between(const Function& function, double low, double high) {
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<double> nearly_all_digits(std::numeric_limits<double>::digits - 2);
  const auto bracket = boost::math::tools::toms748_solve(function, low, high, nearly_all_digits, iterations);
  return bracket.first + (bracket.second - bracket.first) / 2;
}

}  // namespace ramify
