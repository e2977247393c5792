#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "ramify/model/beta.hpp"

namespace ramify {
namespace {

constexpr double steepest = 4;    // largest change of the log density over a cell for the quadrature
constexpr Size end_cells = 8;     // at either end
constexpr double hopeless = -60;  // log of a density that no cell near it can make up for

struct Node {
  double t, weight;
};

/// Gauss and Legendre's nodes on (0,1), ascending.
template <std::size_t points>
std::array<Node, points> unit_nodes() {
  using Gauss = boost::math::quadrature::gauss<double, points>;
  std::array<Node, points> nodes;
  for (std::size_t q = 0; q < points / 2; ++q) {
    const double x = Gauss::abscissa()[q], w = Gauss::weights()[q] / 2;
    nodes[points / 2 + q] = {(1 + x) / 2, w};
    nodes[points / 2 - 1 - q] = {(1 - x) / 2, w};
  }
  return nodes;
}

}  // namespace

Beta::Rows::Rows(const Beta& law)
    : law_(law),
      log_beta_(boost::math::lgamma(law.a_) + boost::math::lgamma(law.b_) -
                boost::math::lgamma(law.a_ + law.b_)) {}  // not std::lgamma: it writes to a global

void Beta::Rows::extend_tables(Size n) {
  static const auto nodes = unit_nodes<points>();
  for (Size i = left_.size(); i < n; ++i) {
    const double middle = static_cast<double>(i) + 0.5;
    auto& left = left_.emplace_back();
    auto& right = right_.emplace_back();
    for (std::size_t q = 0; q < points; ++q) {
      const double off = (nodes[q].t - 0.5) / middle;
      left[q] = nodes[q].weight * std::exp((law_.a_ - 1) * std::log1p(off));
      right[q] = std::exp((law_.b_ - 1) * std::log1p(-off));
    }
    log_left_.push_back((law_.a_ - 1) * std::log(middle));
    log_right_.push_back((law_.b_ - 1) * std::log(middle));
  }
}

/// How much the log density changes over the cell of i: its slope or its curvature, whichever is more.
double Beta::Rows::change(Size i, Size n) const {
  const double x = static_cast<double>(i) + 0.5, y = static_cast<double>(n - 1 - i) + 0.5;
  const double left = (law_.a_ - 1) / x, right = (law_.b_ - 1) / y;
  return std::max(std::abs(left - right), std::abs(left / x + right / y));
}

WeightWindow Beta::Rows::window(Size n) {
  extend_tables(n);
  std::vector<double> weights(n, 0.0);
  const double scale = -log_beta_ - (law_.a_ + law_.b_ - 1) * std::log(static_cast<double>(n));
  for (Size i = 0; i < n; ++i) {
    const Size j = n - 1 - i;
    const double log_middle = log_left_[i] + log_right_[j] + scale;
    const double change = this->change(i, n);
    const bool at_end = i < end_cells || j < end_cells;
    if (!at_end && log_middle + change < hopeless) continue;
    if (at_end || change > steepest) {
      weights[i] = law_.cell_probability(i, n);
      continue;
    }
    double sum = 0;
    for (std::size_t q = 0; q < points; ++q) sum += left_[i][q] * right_[j][q];
    weights[i] = std::exp(log_middle) * sum;
  }
  return {0, std::move(weights)};
}

}  // namespace ramify
