#pragma once

#include <cstddef>
#include <cstdint>

#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Depth D_n of the last node (B23, Theorem 2.1): from size n >= 2 go to a child of size i with probability
/// i / (n-1), end at size 1; nodes on the way, the root counted. theory.md counts edges: one less.
///
/// Needs labels that are sizes. Folded from below: at every fork with two internal children the walk that
/// would arrive there chooses; only the choices along one path matter, and they are independent. Size 0 has
/// depth 0.
class LastNodeDepth {
 public:
  using Value = std::uint32_t;

  explicit LastNodeDepth(Stream walk) : walk_(walk) {}

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels& sizes, const Values& depths) {
    return 1 + depths[choose(sizes)];
  }

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
    Size target = uniform_below(walk_, total);
    std::size_t child = 0;
    while (target >= sizes[child]) target -= sizes[child++];
    return child;
  }

  Stream walk_;
};

}  // namespace ramify
