#include "ramify/model/fixed_split.hpp"

#include "ramify/model/parameter.hpp"

namespace ramify {

FixedSplit::FixedSplit(double x) : x_(x) {
  require_probability("split(x)", "x", x);
}

std::vector<double> FixedSplit::pmf(Size n) const {
  std::vector<double> weights(n, 0.0);
  weights[left(n)] = 1;
  return weights;
}

}  // namespace ramify
