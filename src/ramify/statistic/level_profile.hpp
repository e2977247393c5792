#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The number of nodes on every level, root at level 0, external nodes counted (B3, B23): the profile of a
/// tree, whose largest entry is its width.
///
/// The profile of a node is that of its highest child with the others added to its upper levels and one more
/// level, so a node costs the heights of all its children but the highest: O(nodes) for the whole tree.
/// Profiles of binary trees of up to 8 levels, which are most, are one word. Memory: 8 bytes a level of every
/// larger subtree that waits to be joined.
class LevelProfile {
 public:
  /// The levels of a small subtree, a byte each, the root's (which is 1) lowest; or 256 times the place of a
  /// larger one.
  struct Value {
    std::uint64_t bits;

    bool is_small() const { return (bits & 0xff) != 0; }
    std::size_t place() const { return bits >> 8; }
    std::size_t small_levels() const { return (static_cast<std::size_t>(std::bit_width(bits)) + 7) / 8; }
  };

  Value external() const { return {1}; }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, const Pair<Value>& below) {
    // 8 levels of a binary tree have 128 nodes at most: no byte runs over.
    const bool fit =
        ((below[0].bits | below[1].bits) >> 56) == 0 && below[0].is_small() && below[1].is_small();
    return fit ? Value{(below[0].bits + below[1].bits) << 8 | 1} : join_large(below);
  }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, std::span<const Value> below) {
    return join_large(below);
  }

  /// Nodes of every level of a subtree, from its root down. O(levels).
  std::vector<std::uint64_t> levels(Value root) const {
    if (!root.is_small()) {
      const auto& kept = profiles_[root.place()];
      return {kept.rbegin(), kept.rend()};
    }
    std::vector<std::uint64_t> levels;
    for (std::uint64_t bits = root.bits; bits != 0; bits >>= 8) levels.push_back(bits & 0xff);
    return levels;
  }

  std::uint64_t width(Value root) const { return std::ranges::max(levels(root)); }

 private:
  /// Kept from the deepest level up, so that a level is put on top at the end.
  using Levels = std::vector<std::uint64_t>;

  Value join_large(std::span<const Value> below) {
    const std::size_t highest = highest_of(below);
    Levels& levels = profiles_[highest];
    for (const Value& child : below) {
      if (child.is_small()) {
        add_small(levels, child.bits);
      } else if (child.place() != highest) {
        add_large(levels, child.place());
      }
    }
    levels.push_back(1);
    return {highest << 8};
  }

  /// The place of the highest child's profile; of a new one, with as many levels, where all are small.
  std::size_t highest_of(std::span<const Value> below) {
    std::size_t highest = 0, levels = 0;
    for (const Value& child : below) {
      if (child.is_small()) {
        levels = std::max(levels, child.small_levels());
      } else if (highest == 0 || profiles_[child.place()].size() > profiles_[highest].size()) {
        highest = child.place();
      }
    }
    if (highest == 0) {
      highest = new_place();
      profiles_[highest].assign(levels, 0);
    } else if (profiles_[highest].size() < levels) {
      Levels& kept = profiles_[highest];  // of a wide tree: large without being high
      kept.insert(kept.begin(), levels - kept.size(), 0);
    }
    return highest;
  }

  std::size_t new_place() {
    if (free_.empty()) {
      profiles_.emplace_back();
      return profiles_.size() - 1;
    }
    const std::size_t place = free_.back();
    free_.pop_back();
    return place;
  }

  // Roots on one level.

  static void add_small(Levels& levels, std::uint64_t bits) {
    for (auto level = levels.rbegin(); bits != 0; bits >>= 8) *level++ += bits & 0xff;
  }

  void add_large(Levels& levels, std::size_t other) {
    const Levels& added = profiles_[other];
    std::transform(added.rbegin(), added.rend(), levels.rbegin(), levels.rbegin(), std::plus<>());
    free_.push_back(other);
  }

  std::vector<Levels> profiles_ = std::vector<Levels>(1);  // no profile has place 0
  std::vector<std::size_t> free_;
};

}  // namespace ramify
