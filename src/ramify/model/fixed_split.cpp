#include "ramify/model/fixed_split.hpp"

#include "ramify/model/parameter.hpp"
#include "ramify/model/point_mass.hpp"

namespace ramify {

FixedSplit::FixedSplit(double x) : x_(x) {
  require_probability("split(x)", "x", x);
}

std::vector<double> FixedSplit::pmf(Size n) const {
  return point_mass(n, left(n));
}

}  // namespace ramify
