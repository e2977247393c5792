#include "ramify/theory/depth_constant.hpp"

#include <boost/math/special_functions/digamma.hpp>

#include "ramify/theory/complete_constant.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {

std::optional<Rounded> beta_depth(const BetaSplit& split) {
  using boost::math::digamma;
  const Precise a = split.a, b = split.b;
  const Precise at_root = digamma(a + b + 1);
  const Precise mu = at_root - (a * digamma(a + 1) + b * digamma(b + 1)) / (a + b);
  return round_to_double(1 / mu, (1 + abs(at_root)) / mu);
}

std::optional<Rounded> fixed_depth(const BinarySplit& split) {
  const Precise p = split.smaller, q = split.larger();
  const Precise entropy = -p * log(p) - q * log1p(-p);
  return round_to_double(1 / entropy, 1);
}

std::optional<Constant> depth_constant(const Model& model) {
  const auto beta = BetaSplit::of(model);
  if (beta == uniform_split) return Constant{"depth", 2, 0, "2", "Devroye 1998; C6"};
  if (is_complete(model)) return complete_constant("depth");
  if (beta)
    return make_constant("depth", beta_depth(*beta),
                         "1/mu, mu = psi(a+b+1) - (a psi(a+1) + b psi(b+1))/(a+b)", "Devroye 1998; C6");
  if (const auto binary = BinarySplit::of(model))
    return make_constant("depth", fixed_depth(*binary), "1/(p log(1/p) + q log(1/q)), q = 1-p",
                         "Devroye 1998; C6");
  return std::nullopt;
}

}  // namespace ramify
