#include "ramify/model/chain.hpp"

namespace ramify {

std::vector<double> Chain::pmf(Size n) const {
  std::vector<double> weights(n, 0.0);
  weights.front() += 0.5;
  weights.back() += 0.5;
  return weights;
}

}  // namespace ramify
