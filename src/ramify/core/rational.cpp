#include "ramify/core/rational.hpp"

#include <charconv>
#include <cmath>
#include <numeric>

#include "ramify/core/contract.hpp"
#include "ramify/core/number.hpp"

namespace ramify {
namespace {

/// digits * 10^exponent.
struct Decimal {
  std::uint64_t digits = 0;
  int exponent = 0;
};

/// value * factor + more; nothing where 64 bits do not hold it.
std::optional<std::uint64_t> grown(std::uint64_t value, std::uint64_t factor, std::uint64_t more = 0) {
  if (value > (UINT64_MAX - more) / factor) return std::nullopt;
  return value * factor + more;
}

/// Digits and at most one point, taken off the text.
std::optional<Decimal> take_digits(std::string_view& text) {
  Decimal decimal;
  bool any = false, after_point = false;
  for (; !text.empty() && (is_digit(text[0]) || (text[0] == '.' && !after_point)); text.remove_prefix(1)) {
    if (text[0] == '.') {
      after_point = true;
      continue;
    }
    any = true;
    const auto digits = grown(decimal.digits, 10, static_cast<std::uint64_t>(text[0] - '0'));
    if (!digits) return std::nullopt;
    decimal.digits = *digits;
    if (after_point) --decimal.exponent;
  }
  return any ? std::optional(decimal) : std::nullopt;
}

std::optional<Decimal> parse_decimal(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  auto decimal = take_digits(text);
  if (!decimal || text.empty()) return decimal;
  if (text[0] != 'e' && text[0] != 'E') return std::nullopt;
  text.remove_prefix(text.starts_with("e+") || text.starts_with("E+") ? 2 : 1);
  int exponent = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (status != std::errc() || end != text.data() + text.size() || std::abs(exponent) > 1000)
    return std::nullopt;
  decimal->exponent += exponent;
  return decimal;
}

Rational reduced(std::uint64_t numerator, std::uint64_t denominator) {
  const std::uint64_t common = std::gcd(numerator, denominator);
  return {numerator / common, denominator / common};
}

/// fraction * 10^exponent.
std::optional<Rational> scaled(Rational fraction, int exponent) {
  if (fraction.numerator == 0) return fraction;
  std::uint64_t& larger = exponent > 0 ? fraction.numerator : fraction.denominator;
  std::uint64_t& smaller = exponent > 0 ? fraction.denominator : fraction.numerator;
  for (int i = 0; i < std::abs(exponent); ++i) {
    const std::uint64_t common = std::gcd(smaller, std::uint64_t{10});
    const auto next = grown(larger, 10 / common);
    if (!next) return std::nullopt;
    smaller /= common;
    larger = *next;
  }
  return fraction;
}

}  // namespace

std::optional<Rational> Rational::parse(std::string_view text) {
  const auto slash = text.find('/');
  const auto above = parse_decimal(text.substr(0, slash));
  const auto below = slash == std::string_view::npos ? Decimal{1, 0} : parse_decimal(text.substr(slash + 1));
  if (!above || !below || below->digits == 0) return std::nullopt;
  return scaled(reduced(above->digits, below->digits), above->exponent - below->exponent);
}

Rational Rational::of(double x) {
  RAMIFY_EXPECTS(x >= 0 && x < 1);
  constexpr double all_whole = 0x1p53, scale = 0x1p63;
  double above = 1, above_before = 0, below = 0, below_before = 1, rest = x;
  for (;;) {
    const double whole = std::floor(rest);
    const double next_above = whole * above + above_before, next_below = whole * below + below_before;
    if (!(next_below <= all_whole)) break;
    if (next_above / next_below == x)
      return {static_cast<std::uint64_t>(next_above), static_cast<std::uint64_t>(next_below)};
    above_before = above;
    below_before = below;
    above = next_above;
    below = next_below;
    rest = 1 / (rest - whole);
  }
  return reduced(static_cast<std::uint64_t>(std::round(x * scale)), std::uint64_t{1} << 63);
}

}  // namespace ramify
