#include "ramify/accumulate/order_totals.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/core/contract.hpp"

namespace ramify {

void OrderTotals::add(const HortonStrahler::Counts& counts, std::size_t top) {
  ++trees_;
  highest_ = std::max(highest_, top);
  for (std::size_t k = 0; k <= top; ++k) {
    sums_[k] += counts[k];
    squares_[k] += int128(counts[k]) * counts[k];
    if (k < top) neighbours_[k] += int128(counts[k]) * counts[k + 1];
  }
}

void OrderTotals::merge(const OrderTotals& other) {
  trees_ += other.trees_;
  highest_ = std::max(highest_, other.highest_);
  for (std::size_t k = 0; k <= other.highest_; ++k) {
    sums_[k] += other.sums_[k];
    squares_[k] += other.squares_[k];
    neighbours_[k] += other.neighbours_[k];
  }
}

/// Covariance of the means of two counts.
double OrderTotals::variance_of_mean(const int128& sum_a, const int128& sum_b, const int128& sum_ab) const {
  if (trees_ < 2) return 0;
  using int256 = boost::multiprecision::int256_t;
  const int256 scaled = int256(sum_ab) * trees_ - int256(sum_a) * int256(sum_b);
  const double trees = static_cast<double>(trees_);
  return static_cast<double>(scaled) / (trees * (trees - 1) * trees);
}

Estimate OrderTotals::mean(std::size_t k) const {
  const double mean = static_cast<double>(sums_[k]) / static_cast<double>(trees_);
  return {mean, std::sqrt(variance_of_mean(sums_[k], sums_[k], squares_[k]))};
}

Estimate OrderTotals::pooled_ratio(std::size_t k) const {
  RAMIFY_EXPECTS(k < highest_);
  const double below = mean(k).value, above = mean(k + 1).value;
  const double ratio = below / above;
  // Var(A/B) ~ (Var A - 2 r Cov(A,B) + r^2 Var B) / B^2
  const double variance = variance_of_mean(sums_[k], sums_[k], squares_[k]) -
                          2 * ratio * variance_of_mean(sums_[k], sums_[k + 1], neighbours_[k]) +
                          ratio * ratio * variance_of_mean(sums_[k + 1], sums_[k + 1], squares_[k + 1]);
  return {ratio, std::sqrt(std::max(0.0, variance)) / above};
}

}  // namespace ramify
