#pragma once

#include <algorithm>
#include <cstdint>

namespace ramify {

/// B1 (Shao and Sokal 1990): the sum over all internal nodes but the root of 1 over their height, in edges to
/// the deepest external node below, that of a cherry 1. A node adds those of its children, so that the root
/// is left out.
class B1 {
 public:
  using Value = std::uint32_t;  ///< height in edges

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& heights) {
    for (const Value height : heights)
      if (height > 0) sum_ += 1.0 / height;
    return 1 + *std::max_element(heights.begin(), heights.end());
  }

  double index(Value) const { return sum_; }

 private:
  double sum_ = 0;
};

}  // namespace ramify
