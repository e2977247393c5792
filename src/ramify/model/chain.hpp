#pragma once

#include <cstdint>

#include "ramify/model/split_law.hpp"

namespace ramify {

/// Chain (A4): every internal node but the deepest has one internal child, on the left or on the right by the
/// toss of a coin. Any n to 2^62. Order 1, height n+1, n nodes of order 1: the "gourmand de la vigne" of
/// Viennot 1990, Fitter's (1985) herringbone.
class Chain {
 public:
  static constexpr Size largest_size() { return max_size; }
  static constexpr bool uses_table = false;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    const std::uint64_t heads = stream() >> 63;
    return heads * (n - 1);
  }

  /// 1/2 at 0 and at n-1.
  WeightWindow window(Size n, double cutoff) const;

  /// One side is as good as the other in a row.
  struct Rows {
    explicit Rows(const Chain&) {}
    WeightWindow window(Size) { return {0, {1.0}}; }
  };

  SplitCharacter character() const;
  static const ModelInfo& info();

  friend bool operator==(const Chain&, const Chain&) = default;
};

}  // namespace ramify
