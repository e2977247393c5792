#pragma once

#include <algorithm>
#include <bit>

#include "ramify/model/split_law.hpp"

namespace ramify {

/// Complete binary tree (A3): internal nodes 1..n in level order, those below node i being 2i and 2i+1, as in
/// a heap. Deterministic; any n to 2^62. Knuth 1997, 2.3.4.5.
///
/// Perfect, with all external nodes on one level, where n = 2^k - 1 (the only sizes the sources have); else
/// the last level is filled from the left. Order and fill level are the largest that n nodes can have,
/// floor(log2(n+1)).
class Complete {
 public:
  static constexpr Size largest_size() { return max_size; }
  static constexpr bool uses_table = false;

  template <class Urbg>
  Size left(Size n, Urbg&) const {
    return left(n);
  }

  /// Of n >= 1. The right subtree is perfect up to the last level but one, or has what the left half of the
  /// last level does not hold.
  Size left(Size n) const {
    const Size last_level = std::bit_floor(n);  // places on it
    return n - std::max(last_level / 2, n + 1 - last_level);
  }

  /// 1 at left(n).
  WeightWindow window(Size n, double) const { return {left(n), {1.0}}; }

  SplitCharacter character() const;
  static const ModelInfo& info();

  friend bool operator==(const Complete&, const Complete&) = default;
};

}  // namespace ramify
