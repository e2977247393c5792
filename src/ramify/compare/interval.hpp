#pragma once

#include <cstddef>

namespace ramify {

/// A closed interval.
struct Interval {
  double lower;
  double upper;

  bool contains(double value) const { return lower <= value && value <= upper; }
};

/// How many standard errors a normal estimate leaves, on either side, with probability `chance` over so many
/// estimates together at most (Bonferroni): of one and 0.01 it is 2.576.
/// @param chance  in (0,1)
double simultaneous_sigmas(double chance, std::size_t estimates);

}  // namespace ramify
