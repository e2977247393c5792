#pragma once

#include <algorithm>
#include <cstdint>

#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// Height (B4): nodes on the longest path from the root to an external node, both counted; a single external
/// node has height 1. Most of the literature counts internal levels: one less.
class Height {
 public:
  using Value = std::uint32_t;

  Value external() const { return 1; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& heights) const {
    return 1 + *std::max_element(heights.begin(), heights.end());
  }

  static constexpr LongestPath recurrence{};
};

}  // namespace ramify
