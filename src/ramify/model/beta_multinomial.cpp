#include "ramify/model/beta_multinomial.hpp"

#include <algorithm>

#include "ramify/core/compensated_sum.hpp"
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
  const auto up = [this, last](Size k) {
    const auto left = static_cast<double>(k), right = static_cast<double>(last - k);
    return right / (right - 1 + b_) * ((left + a_) / (left + 1));  // 1 at a = b = 1
  };
  const auto down = [&up](Size k) { return 1 / up(k - 1); };
  WeightWindow found = weights_outward(mode(last), last, a_ < 1 && b_ < 1 ? 0 : cutoff, down, up);
  // Plainly summed, thousands of small weights and one heavy end would miss 1 by 1e-14.
  const double sum = compensated_sum(found.weights);
  for (double& w : found.weights) w /= sum;
  return found;
}

}  // namespace ramify
