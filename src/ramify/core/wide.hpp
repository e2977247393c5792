#pragma once

#include <cstdint>

namespace ramify {

/// A 128-bit product as its two halves.
struct WideProduct {
  std::uint64_t high;
  std::uint64_t low;

  /// Modulo 2^128.
  friend WideProduct operator-(const WideProduct& a, const WideProduct& b) {
    return {a.high - b.high - (a.low < b.low ? 1 : 0), a.low - b.low};
  }
};

/// The full product of two 64-bit integers.
inline WideProduct multiply_wide(std::uint64_t a, std::uint64_t b) {
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
#else
  const std::uint64_t a_low = a & 0xffffffffu, a_high = a >> 32;
  const std::uint64_t b_low = b & 0xffffffffu, b_high = b >> 32;
  const std::uint64_t cross = (a_low * b_low >> 32) + (a_high * b_low & 0xffffffffu) + a_low * b_high;
  return {a_high * b_high + (a_high * b_low >> 32) + (cross >> 32), a * b};
#endif
}

}  // namespace ramify
