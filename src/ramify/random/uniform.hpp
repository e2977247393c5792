#pragma once

#include <cstdint>

#include "ramify/core/contract.hpp"
#include "ramify/core/wide.hpp"

namespace ramify {

/// A uniform integer in 0..bound-1, exactly (Lemire 2019). bound >= 1; one word nearly always.
template <class Urbg>
std::uint64_t uniform_below(Urbg& stream, std::uint64_t bound) {
  RAMIFY_EXPECTS(bound >= 1);
  WideProduct product = multiply_wide(stream(), bound);
  if (product.low < bound) {
    const std::uint64_t threshold = (0 - bound) % bound;
    while (product.low < threshold) product = multiply_wide(stream(), bound);
  }
  return product.high;
}

/// A uniform double in (0,1): the midpoint of one of 2^52 cells (exact, where those of 2^53 would round up to
/// 1 at the end), so log(u) and log(1-u) are finite.
template <class Urbg>
double uniform_open(Urbg& stream) {
  return (static_cast<double>(stream() >> 12) + 0.5) * 0x1p-52;
}

}  // namespace ramify
