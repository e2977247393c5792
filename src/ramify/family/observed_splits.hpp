#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// How the internal nodes below a node divide between its two children, where left and right mean nothing.
struct ObservedSplit {
  Size smaller, larger;  ///< internal nodes of the children
  double count;          ///< so many nodes divide like this

  Size size() const { return smaller + larger + 1; }
  bool is_even() const { return smaller == larger; }
};

/// The splits of one binary tree or of several: all that the likelihood of a split tree depends on.
///
/// Nodes with one or two internal nodes below and including them divide in one way alone, where left and
/// right mean nothing; they are left out.
class ObservedSplits {
 public:
  /// Trees of fewer internal nodes are all alike.
  static constexpr Size smallest_size = 3;

  ObservedSplits() = default;

  /// O(nodes log(nodes)). Throws Error for a tree with a node of other than two children.
  /// @param where  names the tree in messages
  ObservedSplits(const Tree& tree, std::string_view where);

  /// Those of a further tree, or of further trees: their likelihoods multiply.
  void add(const ObservedSplits& others);

  /// By ascending size, then by ascending smaller child; each once.
  std::span<const ObservedSplit> splits() const { return splits_; }

  /// Internal nodes of the trees, one by one.
  std::span<const Size> tree_sizes() const { return tree_sizes_; }

  /// Internal nodes of all trees.
  double nodes() const;

  /// Nodes of size 3 and more, which divide in more ways than one.
  double choices() const;

 private:
  void merge_equal();

  std::vector<ObservedSplit> splits_;
  std::vector<Size> tree_sizes_;
};

}  // namespace ramify
