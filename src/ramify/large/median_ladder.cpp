#include "ramify/large/median_ladder.hpp"

#include <cmath>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// P(X >= k).
Approximation reached(const LargeFiniteLaw& law, std::size_t k) {
  Approximation sum{0, 0};
  for (std::size_t i = 0; i < law.probabilities.size(); ++i) {
    if (law.first + static_cast<double>(i) < static_cast<double>(k)) continue;
    sum.value += law.probabilities[i].value;
    sum.error += law.probabilities[i].error;
  }
  return sum;
}

}  // namespace

MedianLadder::MedianLadder(const LargeLaw& law, AffineMap map, double smallest, double largest)
    : law_(&law),
      map_(map),
      from_(std::log(smallest)),
      to_(std::log(largest)),
      lowest_(median(smallest) + 1),
      highest_(median(largest)) {}

std::size_t MedianLadder::median(double n) const {
  const LargeFiniteLaw law = law_->law(n)->mapped(map_);
  auto k = static_cast<std::size_t>(law.first) + law.probabilities.size();
  while (reached(law, k).value < 0.5) --k;
  return k;
}

double MedianLadder::crossing(std::size_t k, double side) const {
  double below = from_, above = to_;
  constexpr double resolved = 1e-12;
  while (above - below > resolved * above) {
    const double middle = (below + above) / 2;
    const Approximation p = reached(law_->law(std::exp(middle))->mapped(map_), k);
    (p.value + side * p.error < 0.5 ? below : above) = middle;
  }
  return (below + above) / 2;
}

KnownPoint MedianLadder::rung(std::size_t k) const {
  RAMIFY_EXPECTS(k >= lowest_ && k <= highest_);
  const double early = crossing(k, +1), late = crossing(k, -1);
  return {static_cast<double>(k), (early + late) / 2, (late - early) / 2};
}

}  // namespace ramify
