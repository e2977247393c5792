#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ramify {

/// 0 to 9, whatever the locale.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A finite real written as "0.23", "1e-3" or a fraction "1/4.35"; nothing where the text is neither.
std::optional<double> parse_real(std::string_view text);

/// A whole number >= 0 written "1000", "1_000_000", "1e6" or "10^6"; nothing where the text is anything else
/// (negative, fractional, above 2^64-1).
std::optional<std::uint64_t> parse_count(std::string_view text);

/// The shortest text that reads back as the same double.
std::string format_exact(double value);

/// At most so many significant digits, the same bytes on every machine; empty for NaN.
std::string format_significant(double value, int digits);

/// At most 10 of them, as in tables.
std::string format_summary(double value);

}  // namespace ramify
