#include "ramify/compare/judge.hpp"

#include <algorithm>
#include <cmath>

namespace ramify {

Interval sampling_interval(double estimate, double standard_error) {
  return {estimate - interval_sigmas * standard_error, estimate + interval_sigmas * standard_error};
}

Interval growth_interval(const GrowthConstant& growth, Approach approach) {
  const double noise = approach == Approach::settles ? interval_sigmas * growth.drift_error : 0;
  const double drift = std::copysign(std::max(0.0, std::fabs(growth.drift) - noise), growth.drift);
  Interval interval = sampling_interval(growth.slope.value, growth.slope.standard_error);
  interval.lower += std::min(0.0, drift);
  interval.upper += std::max(0.0, drift);
  return interval;
}

Outcome judge(const Interval& interval, double theory, double tolerance) {
  const Interval band{theory - tolerance, theory + tolerance};
  if (interval.lower >= band.lower && interval.upper <= band.upper) return Outcome::reproduced;
  if (interval.upper < band.lower || interval.lower > band.upper) return Outcome::refuted;
  return Outcome::inconclusive;
}

}  // namespace ramify
