#include "ramify/model/beta_multinomial.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/model/parameter.hpp"

namespace ramify {
namespace {

/// Neumaier 1974: a law with one heavy end adds thousands of small weights to a large sum.
double compensated_sum(const std::vector<double>& values) {
  double sum = 0, lost = 0;
  for (const double value : values) {
    const double next = sum + value;
    lost += std::abs(sum) >= std::abs(value) ? (sum - next) + value : (value - next) + sum;
    sum = next;
  }
  return sum + lost;
}

}  // namespace

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
    return right / (left + 1) * ((left + a_) / (right - 1 + b_));
  };
  const auto down = [&up](Size k) { return 1 / up(k - 1); };
  WeightWindow found = weights_outward(mode(last), last, a_ < 1 && b_ < 1 ? 0 : cutoff, down, up);
  const double sum = compensated_sum(found.weights);
  for (double& w : found.weights) w /= sum;
  return found;
}

}  // namespace ramify
