#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// Fill level, or saturation level (B18): the deepest level (root = 0) at which all 2^l nodes exist, external
/// ones counted: 0 for an external node, 1 + min over the children; 0 for a one-child node, which lacks one
/// on the next level. F <= S <= B in every binary tree. Of more children than two it is the level of the
/// highest external node.
class FillLevel {
 public:
  using Value = std::uint8_t;

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& levels) const {
    if (levels.size() < 2) return 0;
    return static_cast<Value>(1 + *std::min_element(levels.begin(), levels.end()));
  }

  /// P(F = k): 1 + the minimum over the children.
  static constexpr std::array<JoinTerm, 2> ways{
      {{LawForm::at, -1, LawForm::from, -1}, {LawForm::from, 0, LawForm::at, -1}}};
  static constexpr JoinRule rule{ways, ways};
  static constexpr BoundedJoin recurrence{&rule};
};

}  // namespace ramify
