#include "ramify/model/beta.hpp"

#include <boost/math/special_functions/beta.hpp>

#include "ramify/model/parameter.hpp"

namespace ramify {

Beta::Beta(double a, double b) : a_(a), b_(b) {
  require_positive("beta(a,b)", "a", a);
  require_positive("beta(a,b)", "b", b);
}

Beta::Tails Beta::tails(Size i, Size n) const {
  const double x = static_cast<double>(i) / static_cast<double>(n);
  const double below = boost::math::ibeta(a_, b_, x);
  if (below < 0.5) return {below, 1 - below};
  const double above = boost::math::ibetac(a_, b_, x);
  return {1 - above, above};
}

double Beta::between(const Tails& low, const Tails& high) {
  return high.below < 0.5 ? high.below - low.below : low.above - high.above;
}

double Beta::cell_probability(Size i, Size n) const {
  return between(tails(i, n), tails(i + 1, n));
}

std::vector<double> Beta::pmf(Size n) const {
  std::vector<double> weights;
  weights.reserve(n);
  Tails low = tails(0, n);
  for (Size i = 0; i < n; ++i) {
    const Tails high = tails(i + 1, n);
    weights.push_back(between(low, high));
    low = high;
  }
  return weights;
}

}  // namespace ramify
