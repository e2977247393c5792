#include "ramify/theory/beta_balance.hpp"

#include <algorithm>

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>

namespace ramify {
namespace {

/// The t that minimises t/theta(t). theta is concave and theta(1) = 0, so there is one minimum.
template <class Theta>
Precise best_exponent(const Theta& theta) {
  constexpr int bits = 34;  // the minimum is stationary: 10 digits of t give 20 of the constant
  const auto bound = [&theta](const Precise& t) -> Precise { return t / theta(t); };
  Precise low = 1.0625, middle = 2, high = 4;
  while (bound(high) < bound(middle)) {
    low = middle;
    middle = high;
    high *= 2;
  }
  return boost::math::tools::brent_find_minima(bound, low, high, bits).first;
}

/// E[X^t; X < 1/2] and E[X^t; X > 1/2], X ~ beta(a,b).
struct Halves {
  Precise below, above;
  Precise largest_log;  ///< of the gamma functions in them

  Halves(const Precise& a, const Precise& b, const Precise& t) {
    using boost::math::lgamma;
    const Precise all = lgamma(a + b + t), part = lgamma(a + t);
    const Precise moment = exp(lgamma(a + b) - lgamma(a) + part - all);
    below = moment * boost::math::ibeta(a + t, b, Precise(0.5));
    above = moment * boost::math::ibetac(a + t, b, Precise(0.5));
    largest_log = 1 + a + b + t + abs(all) + abs(part) + abs(lgamma(a));
  }
};

/// theta and how many units of the last digit it has lost.
struct Theta {
  Precise value, cancelled;

  Theta(const BetaSplit& split, const Precise& t) {
    const Halves left(split.a, split.b, t), right(split.b, split.a, t);
    const Precise remainder = 1 - left.above - right.above;
    value = log(remainder / (left.below + right.below));
    cancelled = std::max(left.largest_log, right.largest_log) * (1 + 1 / remainder) / value;
  }
};

}  // namespace

std::optional<Rounded> beta_balance(const BetaSplit& split) {
  if (std::max(split.a, split.b) > 1e5 || std::min(split.a, split.b) < 1e-20) return std::nullopt;
  const Precise t = best_exponent([&split](const Precise& at) { return Theta(split, at).value; });
  const Theta theta(split, t);
  return round_to_double(t / theta.value, theta.cancelled);
}

Rounded bst_balance() {
  const auto theta = [](const Precise& t) -> Precise { return log1p((t - 1) * exp2(t)); };
  const Precise t = best_exponent(theta);
  return round_to_double(t / theta(t), 1).value();
}

}  // namespace ramify
