#pragma once

#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {

/// Random binary search tree (A14): left uniform on 0..n-1, exactly the shape of n random insertions.
/// Also beta(1,1), terminal growth (A16) and the Yule tree. Any n to 2^62. Devroye 1986.
class Bst {
 public:
  static constexpr Size largest_size() { return max_size; }
  static constexpr bool uses_table = false;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    return uniform_below(stream, n);
  }

  /// P(left = i) = 1/n.
  WeightWindow window(Size n, double) const {
    return {0, std::vector<double>(n, 1 / static_cast<double>(n))};
  }

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const Bst&, const Bst&) = default;
};

}  // namespace ramify
