#include "ramify/core/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace ramify {
namespace {

std::optional<double> parse_plain(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_digits(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> times_power(std::uint64_t value, std::uint64_t base, std::uint64_t exponent) {
  for (std::uint64_t i = 0; i < exponent; ++i) {
    if (base != 0 && value > UINT64_MAX / base) return std::nullopt;
    value *= base;
  }
  return value;
}

}  // namespace

std::optional<double> parse_real(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return parse_plain(text);
  const auto numerator = parse_plain(text.substr(0, slash));
  const auto denominator = parse_plain(text.substr(slash + 1));
  if (!numerator || !denominator || !std::isfinite(*numerator / *denominator)) return std::nullopt;
  return *numerator / *denominator;
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::string digits(text);
  std::erase(digits, '_');
  const auto mark = digits.find_first_of("eE^");
  if (mark == std::string::npos) return parse_digits(digits);
  const auto head = parse_digits(std::string_view(digits).substr(0, mark));
  const auto exponent = parse_digits(std::string_view(digits).substr(mark + 1));
  if (!head || !exponent || *exponent > 64) return std::nullopt;
  return digits[mark] == '^' ? times_power(1, *head, *exponent) : times_power(*head, 10, *exponent);
}

std::string format_exact(double value) {
  return fmt::format("{}", value);
}

std::string format_significant(double value, int digits) {
  if (std::isnan(value)) return "";
  return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

std::string format_summary(double value) {
  return format_significant(value, 10);
}

}  // namespace ramify
