#include "order_ratio_limit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/estimate/limit_slope.hpp"
#include "ramify/large/large_orders.hpp"

namespace ramify {
namespace {

constexpr double ratio_size = 1e12;

/// -log E X_k for k = 1, 2, ..., as long as there are so many streams that what is no multiple of n+1 in E
/// X_k, in relative terms below 1/E M_k of nodes and of streams, does no harm.
std::vector<KnownPoint> log_counts(const LargeOrders& orders, OrderCount::Of of) {
  constexpr double fewest = 1e5;
  const auto streams = orders.means(ratio_size, OrderCount::Of::streams);
  const auto counts = orders.means(ratio_size, of);
  std::vector<KnownPoint> points;
  for (std::size_t k = 1; k < counts.size() && streams[k].value >= fewest; ++k)
    points.push_back({static_cast<double>(k), -std::log(counts[k].value),
                      counts[k].error / counts[k].value + 1 / streams[k].value});
  return points;
}

/// Of all highest orders the one whose bound is least.
struct BestSlope {
  LimitSlope slope;
  double highest;
};
BestSlope best_slope(const std::vector<KnownPoint>& points) {
  constexpr std::size_t fewest_orders = 6;
  if (points.size() < fewest_orders)
    throw Error("no limit of ratios", fmt::format("{} orders have streams enough", points.size()),
                "take larger trees");
  BestSlope best{{0, HUGE_VAL}, 0};
  for (std::size_t count = fewest_orders; count <= points.size(); ++count) {
    const LimitSlope slope =
        settling_slope({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count)});
    if (slope.bound < best.slope.bound || best.highest == 0) best = {slope, points[count - 1].x};
  }
  return best;
}

Basis ratio_basis(const Model& model, OrderCount::Of of, const Cancellation& cancellation) {
  const auto [slope, highest] = best_slope(log_counts(LargeOrders(model, {ratio_size}, cancellation), of));
  return {EvidenceKind::limit,
          Standing::extrapolated,
          std::exp(slope.value),
          {std::exp(slope.value - slope.bound), std::exp(slope.value + slope.bound)},
          ratio_size,
          fmt::format("expected {} of orders {:.0f} and {:.0f} at n = {:.0e}; bound: the geometric tail of "
                      "the changes from order to order, the errors of the laws, one stream an order",
                      of == OrderCount::Of::nodes ? "nodes" : "streams", highest - 1, highest, ratio_size),
          "larger sizes"};
}

}  // namespace

std::function<Basis(const Evidence&)> order_ratio_limit(const Model& model, OrderCount::Of of) {
  return [model, of](const Evidence& evidence) { return ratio_basis(model, of, evidence.cancellation); };
}

}  // namespace ramify
