#include "ramify/law/law_cost.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/law/law_width.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

/// Entries of the split rows of all sizes 1..n.
double row_entries(const SplitFraction& fraction, double n) {
  // One entry a size: the call of a sum costs as much as 25.
  if (splits_in_one_way(fraction)) return n * 25;
  const auto* constant = std::get_if<ConstantFraction>(&fraction);
  if (constant == nullptr) return n * n / 4 + n;
  // A binomial law is above 1e-30 over 23 standard deviations, a row at most half as long as its size.
  const double longest = std::min(n / 2, 23 * std::sqrt(n * constant->p * (1 - constant->p)));
  return n * (1 + 2 * longest / 3);
}

/// What a law keeps for each size, and the time it takes for each entry of a row.
struct Use {
  double bytes;
  double nanoseconds;
};

/// Of each recurrence, up to size n.
struct UseOf {
  const Model& model;
  Size n;
  bool means_alone;

  static constexpr double series = sizeof(double);
  double orders() const { return static_cast<double>(HortonStrahler::largest_order(n)); }
  double bounded_series() const { return 3 * (orders() + 3); }

  Use operator()(std::monostate) const { return {0, 0}; }
  Use operator()(KnownBySize) const { return {0, 0}; }
  Use operator()(BoundedJoin) const { return {bounded_series() * series, 8}; }
  // The width at half the size stands for the mean over all sizes.
  Use operator()(LongestPath) const {
    const double width = height_width(model, n / 2);
    return {13 * width + 36, width};
  }
  Use operator()(WeightedWalk) const {
    const double width = depth_width(model, n / 2);
    return {8 * width + 64, width};
  }
  Use operator()(NodeSum) const { return {2 * series, 8}; }
  Use operator()(const CountOfOrder&) const {
    const double means = bounded_series() + 2 * (orders() + 1), counts = 2 * orders();
    if (means_alone) return {means * series, 20};
    const double moments = counts * (2 * orders() + 4) + counts * (counts + 1) / 2;
    return {(means + moments) * series, 20 + 2 * counts * counts};
  }
};

/// 12345 -> 12000.
Size two_digits(Size n) {
  Size unit = 1;
  while (n / unit >= 100) unit *= 10;
  return n / unit * unit;
}

}  // namespace

LawCost law_cost(const Model& model, const LawWork& work, Size n) {
  const auto size = static_cast<double>(n) + 1;
  const SplitCharacter character = model.character();
  const Use law = std::visit(UseOf{model, n, work.means_alone}, work.recurrence);
  return {size * (character.row.bytes + law.bytes),
          row_entries(character.fraction, size) * (character.row.nanoseconds + law.nanoseconds) * 1e-9};
}

Size largest_affordable(const Model& model, const LawWork& work, const LawCost& limit) {
  Size low = 0, high = model.largest_size();
  while (low < high) {
    const Size middle = high - (high - low) / 2;
    const LawCost cost = law_cost(model, work, middle);
    if (cost.bytes <= limit.bytes && cost.seconds <= limit.seconds)
      low = middle;
    else
      high = middle - 1;
  }
  return two_digits(low);
}

}  // namespace ramify
