#include "ramify/model/branching.hpp"

#include <array>

#include <fmt/format.h>

#include "ramify/model/parameter.hpp"

namespace ramify {

Branching::Branching(double p0, double p1, double p2) {
  const double sum =
      require_distribution(fmt::format("branching({},{},{})", p0, p1, p2), std::array{p0, p1, p2});
  p0_ = p0 / sum;
  p1_ = p1 / sum;
  p2_ = p2 / sum;
}

}  // namespace ramify
