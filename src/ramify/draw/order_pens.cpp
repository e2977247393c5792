#include "ramify/draw/order_pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ramify {
namespace {

constexpr double thickest = 9, largest_factor = 1.6;

// The viridis map (van der Walt and Smith 2015) without its yellow, which is too pale on white; its dark end
// is the root's.
constexpr std::array<Color, 6> map{{{0.37, 0.79, 0.38},
                                    {0.13, 0.66, 0.52},
                                    {0.13, 0.57, 0.55},
                                    {0.19, 0.41, 0.56},
                                    {0.25, 0.27, 0.53},
                                    {0.27, 0.00, 0.33}}};

}  // namespace

OrderPens::OrderPens(std::size_t highest, double thinnest)
    : highest_(highest),
      thinnest_(thinnest),
      factor_(highest == 0 ? 1
                           : std::min(largest_factor,
                                      std::pow(thickest / thinnest, 1 / static_cast<double>(highest)))) {}

Color OrderPens::color(std::size_t order) const {
  if (highest_ == 0) return map.front();
  const double place =
      static_cast<double>(order) / static_cast<double>(highest_) * static_cast<double>(map.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), map.size() - 2);
  const double part = place - static_cast<double>(below);
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = map[below][i] * (1 - part) + map[below + 1][i] * part;
  return color;
}

double OrderPens::width(std::size_t order) const {
  return thinnest_ * std::pow(factor_, static_cast<double>(order));
}

}  // namespace ramify
