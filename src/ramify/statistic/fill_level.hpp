#pragma once

#include <algorithm>
#include <cstdint>

namespace ramify {

/// Fill level, or saturation level (B18): the deepest level (root = 0) at which all 2^l nodes exist, external
/// ones counted: 0 for an external node, 1 + min over the children. F <= S <= B in every binary tree.
class FillLevel {
 public:
  using Value = std::uint8_t;

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& levels) const {
    return static_cast<Value>(1 + *std::min_element(levels.begin(), levels.end()));
  }
};

}  // namespace ramify
