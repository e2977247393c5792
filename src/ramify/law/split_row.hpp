#pragma once

#include <cstddef>
#include <span>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// How the n-1 other nodes of a tree of size n divide, up to reflection: no statistic here tells left from
/// right.
struct SplitRow {
  Size n = 0;
  Size first = 0;                   ///< the smallest size of the smaller child that has a weight
  std::span<const double> weights;  ///< P(smaller child = first + m); they sum to 1

  Size smaller(std::size_t m) const { return first + m; }
  Size larger(std::size_t m) const { return n - 1 - smaller(m); }
};

}  // namespace ramify
