#include "ramify/large/large_reach.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/large/compressed_rows.hpp"
#include "ramify/law/law_width.hpp"

namespace ramify {
namespace {

constexpr Size smallest_table = 1024;
constexpr double least_scatter = 100;  // variance of a binomial split, from which on it is smooth
constexpr Size largest_table = 1 << 15;

}  // namespace

double smooth_from(const Model& model) {
  const SplitFraction fraction = model.character().fraction;
  const auto* constant = std::get_if<ConstantFraction>(&fraction);
  return constant == nullptr ? 0 : least_scatter / (constant->p * (1 - constant->p));
}

Size large_law_table(const Model& model) {
  const double needed = smooth_from(model);
  Size table = smallest_table;
  while (static_cast<double>(table) < needed && table < largest_table) table *= 2;
  return 2 * table;
}

std::string no_large_laws(const Model& model) {
  if (!CompressedRows::exist(model)) return "its splits are known at whole sizes alone";
  if (large_law_table(model) > largest_table)
    return "hardly anything goes to one side, so that exact laws would have to reach too far first";
  return {};
}

double large_law_seconds(const Model& model, const Recurrence& recurrence, double n) {
  const bool by_levels =
      std::holds_alternative<LongestPath>(recurrence) || std::holds_alternative<WeightedWalk>(recurrence);
  const double points = 25 * std::log(std::max(2.0, n / 1000)), places = 150;  // of a grid, of a row
  if (!by_levels) return 0.05 + points * places * 4e-6;
  const double reached = std::min(n, 1e18);  // as a Size; by then any power of n is out of reach
  const double levels = height_width(model, static_cast<Size>(reached)) + 5 * std::log(n);
  return 0.1 + 4 * levels * std::min(points, 2000.0) * places * 20e-9;
}

}  // namespace ramify
