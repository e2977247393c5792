#include "ramify/large/size_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr std::size_t width = Stencil::width;
constexpr double centre = static_cast<double>(width) / 2 - 1;  // a position lies between nodes 3 and 4

/// prod_{r != s} (s - r) of the nodes 0..7.
constexpr std::array<double, width> node_products() {
  std::array<double, width> products{};
  for (std::size_t s = 0; s < width; ++s) {
    products[s] = 1;
    for (std::size_t r = 0; r < width; ++r)
      if (r != s) products[s] *= static_cast<double>(s) - static_cast<double>(r);
  }
  return products;
}

/// Lagrange's weights at `to_last` from node 7, which may be tiny and is not rounded against 7.
std::array<double, width> lagrange(double to_last) {
  static constexpr auto products = node_products();
  std::array<double, width> distance{}, weight{};
  for (std::size_t r = 0; r < width; ++r) distance[r] = to_last + static_cast<double>(width - 1 - r);
  double before = 1;
  for (std::size_t r = 0; r < width; ++r) {
    weight[r] = before / products[r];
    before *= distance[r];
  }
  double after = 1;
  for (std::size_t r = width; r-- > 0;) {
    weight[r] *= after;
    after *= distance[r];
  }
  return weight;
}

}  // namespace

Stencil SizeGrid::between_equal(double beyond) {
  return {0, lagrange(centre + beyond - static_cast<double>(width - 1))};
}

SizeGrid::SizeGrid(Size table_size, double step, double largest) : table_size_(table_size), step_(step) {
  RAMIFY_EXPECTS(table_size >= 64 && step > 0 && step * static_cast<double>(width) <= std::numbers::ln2);
  const double beyond = std::max(0.0, std::log(largest / static_cast<double>(table_size + 1)) / step);
  points_ = lead + static_cast<std::size_t>(std::ceil(beyond)) + width / 2 + 1;
}

double SizeGrid::leaves(std::size_t place) const {
  if (place <= table_size_) return static_cast<double>(place + 1);
  return static_cast<double>(table_size_ + 1) * std::exp(position(place) * step_);
}

Stencil SizeGrid::in_table(double leaves) const {
  const double size = leaves - 1;
  const double nearest = std::round(size);
  if (size == nearest) {
    const auto whole = std::min(static_cast<Size>(nearest), table_size_ - (width - 1));
    Stencil stencil{whole, {}};
    stencil.weight[static_cast<Size>(nearest) - whole] = 1;
    return stencil;
  }
  const double last = static_cast<double>(table_size_) - static_cast<double>(width - 1);
  const double first = std::clamp(std::floor(size) - centre, 0.0, last);
  return {static_cast<std::size_t>(first), lagrange(size - first - static_cast<double>(width - 1))};
}

Stencil SizeGrid::centred(std::size_t place, double log_share) const {
  const double off = log_share / step_;
  const double first = std::floor(off) - centre;
  const auto at = static_cast<std::ptrdiff_t>(place) + static_cast<std::ptrdiff_t>(first);
  // At either end of the grid the stencil is moved inside.
  const auto low = static_cast<std::ptrdiff_t>(first_point()),
             high = static_cast<std::ptrdiff_t>(places() - width);
  const auto inside = std::clamp(at, low, high);
  const double to_last =
      off - static_cast<double>(inside - static_cast<std::ptrdiff_t>(place)) - static_cast<double>(width - 1);
  return {static_cast<std::size_t>(inside), lagrange(to_last)};
}

OwnStencil SizeGrid::one_sided(std::size_t place, double log_share) const {
  const double off = log_share / step_;
  if (std::floor(off) + centre + 2 <= 0) {  // its last node is place or below
    OwnStencil far{centred(place, log_share)};
    if (far.others.first + width - 1 < place) return far;
  }
  OwnStencil near{{place - (width - 1), lagrange(off)}};
  near.own = near.others.weight.back();
  near.others.weight.back() = 0;
  near.not_own = 0;
  for (const double w : near.others.weight) near.not_own += w;
  return near;
}

Stencil SizeGrid::anywhere(double leaves) const {
  if (leaves <= static_cast<double>(table_size_ + 1)) return in_table(leaves);
  const double at = std::log(leaves / static_cast<double>(table_size_ + 1)) / step_;
  const auto place = std::min(first_new_point() + static_cast<std::size_t>(std::ceil(at)), places() - 1);
  return centred(place, (at - position(place)) * step_);
}

}  // namespace ramify
