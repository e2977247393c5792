#include "ramify/law/moments.hpp"

#include <cstddef>

namespace ramify {

Moments moments_of(std::span<const double> pmf, double first) {
  double mean = 0, variance = 0;
  for (std::size_t i = 0; i < pmf.size(); ++i) mean += static_cast<double>(i) * pmf[i];
  for (std::size_t i = 0; i < pmf.size(); ++i) {
    const double deviation = static_cast<double>(i) - mean;
    variance += deviation * deviation * pmf[i];
  }
  return {first + mean, variance};
}

}  // namespace ramify
