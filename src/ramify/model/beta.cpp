#include "ramify/model/beta.hpp"

#include <boost/math/special_functions/beta.hpp>

#include "ramify/model/parameter.hpp"

namespace ramify {

Beta::Beta(double a, double b) : a_(a), b_(b) {
  require_positive("beta(a,b)", "a", a);
  require_positive("beta(a,b)", "b", b);
}

std::vector<double> Beta::pmf(Size n) const {
  const double size = static_cast<double>(n);
  // Tails from both ends: below[i] = P(X < i/n), above[i] = P(X > i/n).
  std::vector<double> below(n + 1), above(n + 1);
  for (Size i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / size;
    below[i] = boost::math::ibeta(a_, b_, x);
    above[i] = boost::math::ibetac(a_, b_, x);
  }
  std::vector<double> weights(n);
  for (Size i = 0; i < n; ++i)
    weights[i] = below[i + 1] < above[i] ? below[i + 1] - below[i] : above[i] - above[i + 1];
  return weights;
}

}  // namespace ramify
