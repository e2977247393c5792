#include "ramify/accumulate/order_totals.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"

namespace ramify {

OrderTotals::OrderTotals(std::uint64_t trees, std::span<const Sums> sums) : trees_(trees) {
  if (sums.empty() || sums.size() > sums_.size())
    throw Error(std::to_string(sums.size()) + " orders", "no tree has as many", "grow the block again");
  std::ranges::copy(sums, sums_.begin());
  highest_ = sums.size() - 1;
}

void OrderTotals::add(const HortonStrahler::Counts& counts, std::size_t top) {
  ++trees_;
  highest_ = std::max(highest_, top);
  for (std::size_t k = 0; k <= top; ++k) {
    sums_[k].counts += counts[k];
    sums_[k].squares += int128(counts[k]) * counts[k];
    if (k < top) sums_[k].neighbours += int128(counts[k]) * counts[k + 1];
  }
}

void OrderTotals::merge(const OrderTotals& other) {
  trees_ += other.trees_;
  highest_ = std::max(highest_, other.highest_);
  for (std::size_t k = 0; k <= other.highest_; ++k) {
    sums_[k].counts += other.sums_[k].counts;
    sums_[k].squares += other.sums_[k].squares;
    sums_[k].neighbours += other.sums_[k].neighbours;
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
  const Sums& a = sums_[k];
  const double mean = static_cast<double>(a.counts) / static_cast<double>(trees_);
  return {mean, std::sqrt(variance_of_mean(a.counts, a.counts, a.squares))};
}

Estimate OrderTotals::pooled_ratio(std::size_t k) const {
  RAMIFY_EXPECTS(k < highest_);
  const Sums &a = sums_[k], &b = sums_[k + 1];
  const double below = mean(k).value, above = mean(k + 1).value;
  const double ratio = below / above;
  // Var(A/B) ~ (Var A - 2 r Cov(A,B) + r^2 Var B) / B^2
  const double variance = variance_of_mean(a.counts, a.counts, a.squares) -
                          2 * ratio * variance_of_mean(a.counts, b.counts, a.neighbours) +
                          ratio * ratio * variance_of_mean(b.counts, b.counts, b.squares);
  return {ratio, std::sqrt(std::max(0.0, variance)) / above};
}

}  // namespace ramify
