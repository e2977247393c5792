#include "ramify/model/dst.hpp"

#include "ramify/model/binomial_weights.hpp"
#include "ramify/model/parameter.hpp"

namespace ramify {

Dst::Dst(double p) : p_(p) {
  require_probability("dst(p)", "p", p);
}

std::vector<double> Dst::pmf(Size n) const {
  return binomial_weights(n - 1, p_);
}

}  // namespace ramify
