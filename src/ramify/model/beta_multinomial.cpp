#include "ramify/model/beta_multinomial.hpp"

#include <algorithm>

#include "ramify/model/beta_binomial.hpp"
#include "ramify/model/parameter.hpp"

namespace ramify {
BetaMultinomial::BetaMultinomial(double a, double b) : a_(a), b_(b) {
  require_positive("beta_multinomial(a,b)", "a", a);
  require_positive("beta_multinomial(a,b)", "b", b);
}

Size BetaMultinomial::mode(Size last) const {
  if (a_ <= 1 || b_ <= 1) return a_ <= b_ ? 0 : last;
  const double share = 1 / (1 + (b_ - 1) / (a_ - 1));
  return std::min(last, static_cast<Size>(share * static_cast<double>(last)));
}

WeightWindow BetaMultinomial::window(Size n, double cutoff) const {
  const Size last = n - 1;
  return BetaBinomial{last, a_, b_}.window(0, last, mode(last), a_ < 1 && b_ < 1 ? 0 : cutoff);
}

}  // namespace ramify
