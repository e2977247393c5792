#pragma once

#include <cstdint>
#include <initializer_list>

namespace ramify {

/// What can be folded over a tree: a fold each.
enum class Folded : std::uint8_t {
  strahler,  ///< the order of the root
  counts,    ///< nodes and streams of every order
  height,
  depth,           ///< the walk to the last node
  external_depth,  ///< the walk to an external node
  fill_level,
  balance,
  path_sums,    ///< path lengths and Colless index
  profile,      ///< nodes of every level
  bi_orders,    ///< orders of siblings
  indices,      ///< of the shape of trees, read off one tree at a time (index_folds.hpp)
  mean_counts,  ///< counts of which those of small subtrees are averaged (sample/mean_counts.hpp)
};

/// A set of folds: what a statistic is read off, or what one pass over a tree makes.
class FoldSet {
 public:
  constexpr FoldSet() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): one fold is a set of them
  constexpr FoldSet(Folded fold) : bits_(std::uint32_t{1} << static_cast<unsigned>(fold)) {}
  constexpr FoldSet(std::initializer_list<Folded> folds) {
    for (const Folded fold : folds) bits_ |= FoldSet(fold).bits_;
  }

  constexpr bool empty() const { return bits_ == 0; }
  constexpr bool contains(FoldSet part) const { return (part.bits_ & ~bits_) == 0; }

  friend constexpr FoldSet operator|(FoldSet a, FoldSet b) {
    a.bits_ |= b.bits_;
    return a;
  }
  friend constexpr bool operator==(FoldSet, FoldSet) = default;

 private:
  std::uint32_t bits_ = 0;
};

}  // namespace ramify
