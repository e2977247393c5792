#include "ramify/model/aldous.hpp"

#include "ramify/model/beta_binomial.hpp"
#include "ramify/model/parameter.hpp"

namespace ramify {

Aldous::Aldous(double beta) : beta_(beta) {
  require_above("aldous(beta)", "beta", beta, -2,
                "give a number above -2: 0 for the bst, -1.5 for catalan, -1 in between");
}

WeightWindow Aldous::window(Size n, double cutoff) const {
  const BetaBinomial leaves{n + 1, beta_ + 1, beta_ + 1};
  return beta_ < 0 ? leaves.window(1, n, 1, 0) : leaves.window(1, n, (n + 1) / 2, cutoff);
}

}  // namespace ramify
