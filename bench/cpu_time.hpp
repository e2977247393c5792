#pragma once

#include <ctime>

namespace ramify::bench {

/// Processor seconds (user and system) of this process that the work takes: unlike the wall clock, free of
/// the turns other processes get. Of all threads together; most programs here run on one.
template <class Work>
double cpu_seconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace ramify::bench
