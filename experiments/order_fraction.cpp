#include "order_fraction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <fmt/format.h>

#include "ramify/large/large_orders.hpp"

namespace ramify {
namespace {

constexpr double largest_fraction_size = 1e12;

/// A quantity at the largest size, bounded by twice its changes from smaller ones and by the errors of the
/// laws.
Basis settled(const std::function<Approximation(double n)>& value, std::string_view what) {
  const Approximation last = value(largest_fraction_size);
  double bound = 0;
  for (const double part : {4.0, 16.0, 64.0}) {
    const Approximation before = value(largest_fraction_size / part);
    bound = std::max(bound, 2 * std::abs(before.value - last.value) + before.error + last.error);
  }
  return extrapolated(
      last.value, bound, largest_fraction_size,
      fmt::format(
          "{} at n = {:.0e}; bound: twice its change from n/64, n/16, n/4, and the errors of the laws", what,
          largest_fraction_size));
}

LargeOrders orders_of(const Model& model, const Cancellation& cancellation) {
  std::vector<double> sizes;
  for (const double part : {64.0, 16.0, 4.0, 1.0}) sizes.push_back(largest_fraction_size / part);
  return {model, sizes, cancellation};
}

}  // namespace

Basis first_order_fraction(const Model& model, const Cancellation& cancellation) {
  const LargeOrders orders = orders_of(model, cancellation);
  return settled(
      [&](double n) {
        const Approximation mean = orders.means(n, OrderCount::Of::nodes).at(1);
        return Approximation{mean.value / n, mean.error / n};
      },
      "exact E N_1/n");
}

Basis middle_order_ratio(const Model& model, OrderCount count, const Cancellation& cancellation) {
  const LargeOrders orders = orders_of(model, cancellation);
  return settled(
      [&](double n) {
        const auto means = orders.means(n, count.of);
        const Approximation below = means.at(count.order), above = means.at(count.order + 1);
        const double ratio = below.value / above.value;
        return Approximation{ratio, ratio * (below.error / below.value + above.error / above.value)};
      },
      fmt::format("exact ratio of the means of orders {} and {}", count.order, count.order + 1));
}

}  // namespace ramify
