#include "ramify/accumulate/whole_summary.hpp"

#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/core/int128.hpp"

namespace ramify {
namespace {

// Sums of squares of counts near 2^50 over 2^40 trees do not fit 128 bits: one size up is free of thought.
using int256 = boost::multiprecision::int256_t;

}  // namespace

void WholeSummary::merge(const WholeSummary& other) {
  for (const auto& [value, times] : other.occurrences_) add(value, times);
}

std::uint64_t WholeSummary::count() const {
  std::uint64_t total = 0;
  for (const auto& [value, times] : occurrences_) total += times;
  return total;
}

double WholeSummary::mean() const {
  int128 sum = 0;
  for (const auto& [value, times] : occurrences_) sum += int128(value) * times;
  return static_cast<double>(sum) / static_cast<double>(count());
}

double WholeSummary::variance() const {
  const std::uint64_t total = count();
  if (total < 2) return 0;
  int256 sum = 0, squares = 0;
  for (const auto& [value, times] : occurrences_) {
    sum += int256(value) * times;
    squares += int256(value) * value * times;
  }
  const int256 scaled = squares * total - sum * sum;
  return static_cast<double>(scaled) / (static_cast<double>(total) * static_cast<double>(total - 1));
}

std::int64_t WholeSummary::quantile(double level) const {
  RAMIFY_EXPECTS(!occurrences_.empty() && level > 0 && level <= 1);
  const double wanted = level * static_cast<double>(count());
  std::uint64_t seen = 0;
  for (const auto& [value, times] : occurrences_) {
    seen += times;
    if (static_cast<double>(seen) >= wanted) return value;
  }
  return max();
}

}  // namespace ramify
