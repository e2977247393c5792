#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>

#include "ramify/core/contract.hpp"

namespace ramify {

/// Symmetry nodes index (Kersting and Fischer 2021): the nodes with two children whose subtrees have
/// different shapes, left and right not told apart. NaN of a tree with a node of three children or more; a
/// one-child node has the shape of its child.
///
/// Every shape gets a number when it first comes up. Memory: some 50 bytes for each shape, of which a random
/// tree of n nodes has less than n; fewer than 2^32.
class SymmetryNodes {
 public:
  using Value = std::uint32_t;  ///< number of the shape

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& shapes) {
    if (shapes.size() == 1) return shapes[0];
    if (shapes.size() > 2) {
      asymmetric_ = std::numeric_limits<double>::quiet_NaN();
      return 0;
    }
    const auto [low, high] = std::minmax(shapes[0], shapes[1]);
    if (low != high) ++asymmetric_;
    const auto next = static_cast<Value>(numbers_.size() + 1);
    RAMIFY_EXPECTS(next != 0);
    return numbers_.try_emplace(std::uint64_t{high} << 32 | low, next).first->second;
  }

  double index(Value) const { return asymmetric_; }

 private:
  std::unordered_map<std::uint64_t, Value> numbers_;
  double asymmetric_ = 0;
};

}  // namespace ramify
