#include "ramify/law/height_law.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double carried = 1e-35;
constexpr double stated = 1e-20;

}  // namespace

HeightLaw::HeightLaw() : places_{{1, 1, 1}} {}

void HeightLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes());
  places_.push_back(lower_tail(row, upper_tail(row, reach(row))));
}

/// The heights where the new size may have 0 < D < 1.
HeightLaw::Place HeightLaw::reach(const SplitRow& row) const {
  Size low = sizes() + 2, high = 0;
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const Place& a = places_[row.smaller(m)];
    const Place& b = places_[row.larger(m)];
    low = std::min(low, 1 + std::max(a.lowest, b.lowest));
    high = std::max(high, 1 + std::max(a.high, b.high));
  }
  return {low, high, high};
}

/// From the top down to where D exceeds 1/2.
HeightLaw::Place HeightLaw::upper_tail(const SplitRow& row, Place place) {
  for (; place.middle > place.lowest; --place.middle) {
    const Size h = place.middle - 1;
    const double d = over_either_child(row, above_at(h - 1));
    if (d > 0.5) break;
    if (d < carried)
      place.high = h;
    else
      above_at(h).append(d);
  }
  return place;
}

/// From there down to where L vanishes.
HeightLaw::Place HeightLaw::lower_tail(const SplitRow& row, Place place) {
  const Size possible = place.lowest;
  for (place.lowest = place.middle; place.lowest > possible; --place.lowest) {
    const Size h = place.lowest - 1;
    const SizeSeries& both = at_most_at(h - 1);
    const double l = over_children(row, both, both);
    if (l < carried) break;
    at_most_at(h).append(l);
  }
  return place;
}

/// D of the height h, up to the last size that is stored.
TailSeries& HeightLaw::above_at(Size h) {
  if (h >= levels_.size()) levels_.resize(h + 1);
  TailSeries& series = levels_[h].above;
  while (series.sizes() < sizes()) series.append(above(series.sizes(), h));
  return series;
}

/// L of the height h.
SizeSeries& HeightLaw::at_most_at(Size h) {
  if (h >= levels_.size()) levels_.resize(h + 1);
  SizeSeries& series = levels_[h].at_most;
  while (series.sizes() < sizes()) series.append(at_most(series.sizes(), h));
  return series;
}

double HeightLaw::above(Size n, Size h) const {
  RAMIFY_EXPECTS(n < sizes());
  const Place& place = places_[n];
  if (h < place.lowest) return 1;
  if (h < place.middle) return 1 - levels_[h].at_most[n];
  return h < place.high ? levels_[h].above[n] : 0;
}

double HeightLaw::at_most(Size n, Size h) const {
  RAMIFY_EXPECTS(n < sizes());
  const Place& place = places_[n];
  if (h < place.lowest) return 0;
  return h < place.middle ? levels_[h].at_most[n] : 1 - above(n, h);
}

/// P(H_n = h).
double HeightLaw::at(Size n, Size h) const {
  const Size middle = places_[n].middle;
  if (h < middle) return at_most(n, h) - at_most(n, h - 1);
  return h > middle ? above(n, h - 1) - above(n, h) : 1 - at_most(n, h - 1) - above(n, h);
}

Size HeightLaw::lowest(Size n) const {
  RAMIFY_EXPECTS(n < sizes());
  Size h = places_[n].lowest;
  while (at_most(n, h) < stated) ++h;
  return h;
}

std::vector<double> HeightLaw::pmf(Size n) const {
  RAMIFY_EXPECTS(n < sizes());
  std::vector<double> probabilities;
  for (Size h = lowest(n); above(n, h - 1) >= stated; ++h) probabilities.push_back(std::max(0.0, at(n, h)));
  return probabilities;
}

Moments HeightLaw::moments(Size n) const {
  RAMIFY_EXPECTS(n < sizes());
  const Place& place = places_[n];
  // E X and E X^2 of X = (H - middle)^+ and of X = (middle - H)^+ from the sums of P(X > i).
  double over = 0, over_square = 0, under = 0, under_square = 0;
  for (Size h = place.middle; h < place.high; ++h) {
    over += above(n, h);
    over_square += static_cast<double>(2 * (h - place.middle) + 1) * above(n, h);
  }
  for (Size h = place.lowest; h < place.middle; ++h) {
    under += at_most(n, h);
    under_square += static_cast<double>(2 * (place.middle - h) - 1) * at_most(n, h);
  }
  const double mean = over - under;
  return {static_cast<double>(place.middle) + mean, std::max(0.0, over_square + under_square - mean * mean)};
}

}  // namespace ramify
