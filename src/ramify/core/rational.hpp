#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace ramify {

/// A fraction >= 0 of whole numbers, in lowest terms: a number as it is written, "0.29" or "1/4.35", where a
/// double is only near it.
struct Rational {
  std::uint64_t numerator = 0;
  std::uint64_t denominator = 1;

  /// "0.29" is 29/100, "1/4.35" is 100/435, "25e-2" is 1/4. Nothing where the text is no such number, is
  /// negative, or has more digits than 64 bits hold (19 at most).
  static std::optional<Rational> parse(std::string_view text);

  /// What a double stands for, 0 <= x < 1: the first convergent of its continued fraction whose nearest
  /// double it is, so that what was written or computed as p/q comes back as p/q (0.29 as 29/100, 1.0/3 as
  /// 1/3) where q is below 2^26 or so; else the double itself to 2^-63.
  static Rational of(double x);

  friend bool operator==(const Rational&, const Rational&) = default;
};

}  // namespace ramify
