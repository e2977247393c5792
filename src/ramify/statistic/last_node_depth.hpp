#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/statistic/exact_law.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Makes a walk's choices at random.
class RandomWalk {
 public:
  explicit RandomWalk(Stream stream) : stream_(stream) {}

  /// i with probability weights[i] / total.
  template <class Weights>
  std::size_t choose(const Weights& weights, Size total) {
    Size target = uniform_below(stream_, total);
    std::size_t i = 0;
    if constexpr (std::same_as<Weights, Pair<Size>>) {
      i = target >= weights[0] ? 1 : 0;  // without a branch, which would be a coin toss
      return i;
    }
    while (target >= weights[i]) target -= weights[i++];
    return i;
  }

 private:
  Stream stream_;
};

/// Depth D_n of the last node (B23, Theorem 2.1): from size n >= 2 go to a child of size i with probability
/// i / (n-1), end at size 1; nodes on the way, the root counted. The literature often counts edges: one less.
///
/// Needs labels that are sizes. Folded from below: at every fork with two internal children the walk that
/// would arrive there chooses; only the choices along one path matter, and they are independent. Size 0 has
/// depth 0. @tparam Walk  RandomWalk, or, where laws are computed, one that tries every choice
/// (outcome_law.hpp)
template <class Walk>
class LastNodeDepthOf {
 public:
  using Value = std::uint32_t;

  explicit LastNodeDepthOf(Walk walk) : walk_(walk) {}

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels& sizes, const Values& depths) {
    return 1 + depths[choose(sizes)];
  }

  static constexpr WeightedWalk recurrence{0};

 private:
  /// A child with probability proportional to its size; an index of value 0 where all are external.
  template <class Labels>
  std::size_t choose(const Labels& sizes) {
    Size total = 0;
    std::size_t last_internal = 0, internal = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      total += sizes[i];
      if (sizes[i] == 0) continue;
      last_internal = i;
      ++internal;
    }
    if (internal < 2) return last_internal;
    return walk_.choose(sizes, total);
  }

  Walk walk_;
};

using LastNodeDepth = LastNodeDepthOf<RandomWalk>;

}  // namespace ramify
