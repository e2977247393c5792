#include "ramify/statistic/horton_law.hpp"

#include <cmath>
#include <limits>

namespace ramify {

double horton_size(double ratio, double order) {
  if (!(ratio > 0)) return std::numeric_limits<double>::quiet_NaN();
  return ratio == 1 ? order : std::expm1(order * std::log(ratio)) / (ratio - 1);
}

double horton_order(double ratio, double n) {
  if (!(ratio > 0) || !(n * (ratio - 1) > -1)) return std::numeric_limits<double>::quiet_NaN();
  return ratio == 1 ? n : std::log1p(n * (ratio - 1)) / std::log(ratio);
}

}  // namespace ramify
