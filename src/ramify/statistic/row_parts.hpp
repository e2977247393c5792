#pragma once

#include <cstdint>
#include <limits>

#include "ramify/statistic/statistic_info.hpp"

/// What rows of the registry are made of.
namespace ramify::detail {

using Read = StatisticValue (*)(const TreeMeasures&, OrderPlace);

inline StatisticValue whole(std::uint64_t value) {
  StatisticValue result;
  result.whole = static_cast<std::int64_t>(value);
  return result;
}

inline StatisticValue real(double value) {
  StatisticValue result;
  result.real = value;
  return result;
}

/// NaN where nothing is divided.
inline StatisticValue quotient(double above, double below) {
  return real(below == 0 ? std::numeric_limits<double>::quiet_NaN() : above / below);
}
inline StatisticValue quotient(std::uint64_t above, std::uint64_t below) {
  return quotient(static_cast<double>(above), static_cast<double>(below));
}

constexpr StatisticInfo binary(StatisticInfo row) {
  row.needs_binary = true;
  return row;
}

}  // namespace ramify::detail
