#include "ramify/law/height_law.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double surely = 1 - 0x1p-51;
constexpr double hardly = 1e-20;

}  // namespace

HeightLaw::HeightLaw() : places_{{1, 1, 0}} {}

void HeightLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes());
  const Place all = reach(row);
  out_.assign(all.high - all.low, 0.0);
  certain_.assign(all.high - all.low + 1, 0.0);
  for (std::size_t m = 0; m < row.weights.size(); ++m)
    add_pair(row.weights[m], places_[row.smaller(m)], places_[row.larger(m)], all.low);
  double weight = 0;
  for (std::size_t i = out_.size(); i-- > 0;) out_[i] += weight += certain_[i + 1];
  append(all.low);
}

/// The heights where the new size may have 0 < D < 1.
HeightLaw::Place HeightLaw::reach(const SplitRow& row) const {
  Place all{sizes() + 2, 0, 0};
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const Place& a = places_[row.smaller(m)];
    const Place& b = places_[row.larger(m)];
    all.low = std::min(all.low, 1 + std::max(a.low, b.low));
    all.high = std::max(all.high, 1 + std::max(a.high, b.high));
  }
  return all;
}

/// Adds weight P(max(H_a, H_b) + 1 > h) to the D of the new size, whose first entry is h = low.
void HeightLaw::add_pair(double weight, const Place& a, const Place& b, Size low) {
  const Place& shorter = a.high <= b.high ? a : b;
  const Place& longer = a.high <= b.high ? b : a;
  const Size from = std::max(a.low, b.low);
  certain_[from + 1 - low] += weight;
  const Size both = std::max(from, shorter.high);
  const double* d_long = above_.data() + longer.begin;
  double* out = out_.data();
  if (from < both) {
    const double* d_short = above_.data() + shorter.begin + (from - shorter.low);
    const double* d = d_long + (from - longer.low);
    double* o = out + (from + 1 - low);
    for (Size i = 0, count = both - from; i < count; ++i)
      o[i] += weight * (d_short[i] + d[i] * (1 - d_short[i]));
  }
  const double* d = d_long + (both - longer.low);
  double* o = out + (both + 1 - low);
  for (Size i = 0, count = longer.high - both; i < count; ++i) o[i] += weight * d[i];
}

/// Stores the new size without what is as good as 1 or 0.
void HeightLaw::append(Size low) {
  std::size_t begin = 0, end = out_.size();
  while (begin < end && out_[begin] > surely) ++begin;
  while (end > begin && out_[end - 1] < hardly) --end;
  places_.push_back({low + begin, low + end, above_.size()});
  above_.insert(above_.end(), out_.begin() + static_cast<std::ptrdiff_t>(begin),
                out_.begin() + static_cast<std::ptrdiff_t>(end));
}

double HeightLaw::above(Size n, Size h) const {
  RAMIFY_EXPECTS(n < sizes());
  const Place& place = places_[n];
  if (h < place.low) return 1;
  return h < place.high ? above_[place.begin + (h - place.low)] : 0;
}

std::vector<double> HeightLaw::pmf(Size n) const {
  RAMIFY_EXPECTS(n < sizes());
  std::vector<double> probabilities;
  for (Size h = places_[n].low; h <= places_[n].high; ++h)
    probabilities.push_back(std::max(0.0, above(n, h - 1) - above(n, h)));
  return probabilities;
}

Moments HeightLaw::moments(Size n) const {
  RAMIFY_EXPECTS(n < sizes());
  const Place& place = places_[n];
  // About low: E(H - low) and E(H - low)^2 from the tail sums; H >= low always.
  double first = 0, second = 0;
  for (Size i = 0; i < place.high - place.low; ++i) {
    const double d = above_[place.begin + i];
    first += d;
    second += static_cast<double>(2 * i + 1) * d;
  }
  return {static_cast<double>(place.low) + first, std::max(0.0, second - first * first)};
}

}  // namespace ramify
