#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Path lengths and balance indices: sums over the internal nodes of what is below them (B23).
///
/// path_length: the sum of the depths of all internal nodes, in edges from the root; every node adds the
/// internal nodes below it. sackin: the same for all external nodes (Sackin 1972; Knuth's external path
/// length, path_length + 2n in a binary tree); every node adds the external nodes below it. colless: the sum
/// over the nodes with two children of the difference of their numbers of external nodes (Colless 1982);
/// n(n-1)/2 for a chain, 0 for a complete tree. Needs labels that are sizes. Exact below 2^64: any tree to n
/// = 4*10^9, a random one of any size.
class ShapeIndices {
 public:
  using Value = Size;  ///< external nodes

  Value external() const { return 1; }

  template <class Label, class Labels, class Values>
  Value join(const Label& size, const Labels&, const Values& leaves_below) {
    Size leaves = 0;
    for (const Size below : leaves_below) leaves += below;
    path_length_ += size - 1;
    sackin_ += leaves;
    if (leaves_below.size() > 2) is_wide_ = true;
    if (leaves_below.size() == 2) {
      const Size left = leaves_below[0], right = leaves_below[1];
      colless_ += left > right ? left - right : right - left;
    }
    return leaves;
  }

  /// What a node of a binary tree adds to each.
  static double path_length_toll(std::span<const double> leaves) { return sackin_toll(leaves) - 2; }
  static double sackin_toll(std::span<const double> leaves) {
    return std::accumulate(leaves.begin(), leaves.end(), 0.0);
  }
  static double colless_toll(std::span<const double> leaves) { return std::abs(leaves[0] - leaves[1]); }

  std::uint64_t path_length() const { return path_length_; }
  std::uint64_t sackin() const { return sackin_; }
  std::uint64_t colless() const { return colless_; }
  /// A node has three children or more: colless says nothing of such a tree.
  bool is_wide() const { return is_wide_; }

 private:
  std::uint64_t path_length_ = 0, sackin_ = 0, colless_ = 0;
  bool is_wide_ = false;
};

}  // namespace ramify
