#include "ramify/statistic/murray_exponent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ramify {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// x with sum of exp(-x d_i) = 1, d_i = log(r0/r_i) > 0. The sum is convex and falls from the number of
/// children to 0, so Newton's steps from x = 0 stay below the root and climb to it.
double solved(std::span<const double> drops) {
  double x = 0;
  for (int step = 0; step < 200; ++step) {
    double excess = -1, slope = 0;
    for (const double drop : drops) {
      const double term = std::exp(-x * drop);
      excess += term;
      slope += drop * term;
    }
    const double next = x + excess / slope;
    if (!(next > x * (1 + 1e-14))) return x;
    x = next;
  }
  return x;
}

/// The exponent of one fork; NaN where a radius is not known.
double exponent(double parent, std::span<const double> children) {
  std::vector<double> drops;
  bool thinner = true;
  for (const double child : children) {
    if (!(child > 0)) return std::numeric_limits<double>::quiet_NaN();
    drops.push_back(std::log(parent / child));
    thinner = thinner && child < parent;
  }
  return thinner ? solved(drops) : infinite;
}

double median_of(std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  const double upper = *middle;
  const double lower = values.size() % 2 == 1 ? upper : *std::max_element(values.begin(), middle);
  return std::isinf(upper) ? std::numeric_limits<double>::quiet_NaN() : (lower + upper) / 2;
}

}  // namespace

MurrayExponent murray_exponent(const Tree& tree, std::span<const double> radii) {
  std::vector<double> exponents, open;
  for (std::size_t node = radii.empty() ? 0 : tree.node_count(); node-- > 0;) {
    const std::size_t children = tree.arity(node);
    const auto below = std::span(open).last(children);
    if (children > 1 && radii[node] > 0) {
      const double x = exponent(radii[node], below);
      if (!std::isnan(x)) exponents.push_back(x);
    }
    open.resize(open.size() - children);
    open.push_back(radii[node]);
  }
  const auto count = static_cast<std::uint64_t>(std::ranges::count(exponents, infinite));
  return {median_of(exponents), exponents.size(), count};
}

}  // namespace ramify
