#pragma once

#include <cstdint>
#include <vector>

#include "ramify/family/observed_splits.hpp"

namespace ramify {

/// The sizes that occur in splits, each once, so that what depends on one size is computed once.
///
/// Of a tree of n nodes some sqrt(n) sizes occur.
struct SplitSizes {
  /// A split by places in `sizes`.
  struct Places {
    std::uint32_t smaller, larger, node;
  };

  std::vector<Size> sizes;       ///< ascending, of children and of nodes
  std::vector<double> children;  ///< children of each size
  std::vector<double> nodes;     ///< nodes of each size, those that divide
  std::vector<Places> places;    ///< of the splits, in their order

  explicit SplitSizes(const ObservedSplits& observed);
};

}  // namespace ramify
