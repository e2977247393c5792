#pragma once

namespace ramify {

/// Mean and variance of a statistic; the variance is NaN where only the mean is known.
struct Moments {
  double mean;
  double variance;
};

}  // namespace ramify
