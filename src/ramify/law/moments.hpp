#pragma once

#include <span>

#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// Mean and variance of a statistic; the variance is NaN where only the mean is known.
struct Moments {
  double mean;
  double variance;

  Moments mapped(AffineMap map) const {
    return {map.factor * mean + map.shift, map.factor * map.factor * variance};
  }
};

/// Of the law P(V = first + i) = pmf[i], which sums to 1. The variance is taken about the mean. O(length).
Moments moments_of(std::span<const double> pmf, double first);

}  // namespace ramify
