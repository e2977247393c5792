#include "growth_limit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "ramify/estimate/limit_slope.hpp"
#include "ramify/large/large_law.hpp"
#include "ramify/large/median_ladder.hpp"

namespace ramify {
namespace {

using Approach = GrowthLadder::Approach;
using Rungs = GrowthLadder::Rungs;

/// n = largest/4^9, ..., largest/4, largest.
std::vector<double> descending_by_4(double largest) {
  std::vector<double> sizes;
  for (int j = 9; j >= 0; --j) sizes.push_back(largest / std::pow(4.0, j));
  return sizes;
}

/// Sizes from the table of exact laws to the largest, evenly in log n: where errors are looked at.
std::vector<double> sizes_to(double largest, double smallest) {
  constexpr int steps = 12;
  std::vector<double> sizes;
  for (int j = 1; j < steps; ++j) sizes.push_back(smallest * std::pow(largest / smallest, j / double{steps}));
  sizes.push_back(largest);
  return sizes;
}

LimitSlope limit_slope(const std::vector<KnownPoint>& points, Approach approach) {
  return approach == Approach::settles ? settling_slope(points) : drifting_slope(points);
}

std::string in_words(const LimitSlope& slope, Approach approach) {
  if (!std::isfinite(slope.bound)) return "its steps do not settle";
  return approach == Approach::settles
             ? "the last step; bound: the geometric tail of its changes, and the errors of the laws"
             : "with terms log k and powers of k^(-1/2) fitted; bound: thrice the change from one and two "
               "terms fewer, and the errors of the laws";
}

Basis by_moments(const Model& model, const GrowthLadder& ladder, const Cancellation& cancellation) {
  const ExactLaw& exact = ladder.statistic->law;
  const auto sizes = descending_by_4(ladder.largest_n);
  const LargeLaw law(model, exact.recurrence, sizes, cancellation);
  std::vector<KnownPoint> points;
  for (const double n : sizes) {
    const LargeMoments moments = law.moments(n).mapped(exact.map(n));
    const Approximation& value = ladder.rungs == Rungs::means ? moments.mean : moments.variance;
    points.push_back({std::log(n), value.value, value.error});
  }
  const LimitSlope slope = limit_slope(points, ladder.approach);
  return extrapolated(slope.value, slope.bound, ladder.largest_n,
                      fmt::format("slope of the {} on log n at n = {:.3g}, {:.3g}, ..., {:.3g}: {}",
                                  ladder.rungs == Rungs::means ? "mean" : "variance", sizes[0], sizes[1],
                                  sizes.back(), in_words(slope, ladder.approach)));
}

/// The last rungs, or some between a quarter of the way and the last, evenly in log k.
std::vector<KnownPoint> rungs_of(const MedianLadder& medians, Approach approach) {
  const auto top = static_cast<double>(medians.highest());
  const bool settles = approach == Approach::settles;
  constexpr std::size_t last_rungs = 8, spread_rungs = 16;
  const std::size_t count = settles ? last_rungs : spread_rungs;
  const double first = settles ? top - static_cast<double>(count - 1) : top / 4;
  std::vector<KnownPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1);
    const double place = settles ? first + static_cast<double>(i) : first * std::pow(top / first, part);
    const auto k = std::max(medians.lowest(), static_cast<std::size_t>(std::lround(place)));
    if (points.empty() || points.back().x < static_cast<double>(k)) points.push_back(medians.rung(k));
  }
  return points;
}

Basis by_medians(const Model& model, const GrowthLadder& ladder, const Cancellation& cancellation) {
  const ExactLaw& exact = ladder.statistic->law;
  const auto smallest = static_cast<double>(large_law_table(model));
  const LargeLaw law(model, exact.recurrence, sizes_to(ladder.largest_n, smallest), cancellation);
  const MedianLadder medians(law, exact.map(ladder.largest_n), smallest, ladder.largest_n);
  const auto points = rungs_of(medians, ladder.approach);
  const LimitSlope slope = limit_slope(points, ladder.approach);
  return {
      EvidenceKind::limit,
      Standing::extrapolated,
      1 / slope.value,
      {1 / (slope.value + slope.bound),
       slope.bound < slope.value ? 1 / (slope.value - slope.bound) : HUGE_VAL},
      ladder.largest_n,
      fmt::format("slope of log n_k on k, where P(X >= k) = 1/2 at n_k, k = {:.0f}..{:.0f}, n to {:.3g}: {}",
                  points.front().x, points.back().x, ladder.largest_n, in_words(slope, ladder.approach)),
      "larger sizes"};
}

Basis growth(const Model& model, const GrowthLadder& ladder, const Cancellation& cancellation) {
  return ladder.rungs == Rungs::medians ? by_medians(model, ladder, cancellation)
                                        : by_moments(model, ladder, cancellation);
}

}  // namespace

Basis GrowthLimits::of(const Model& model, const GrowthLadder& ladder, const Cancellation& cancellation) {
  const std::string key =
      fmt::format("{} {} {} {} {}", model.text(), ladder.statistic->name, static_cast<int>(ladder.rungs),
                  static_cast<int>(ladder.approach), ladder.largest_n);
  std::promise<Basis> mine;
  std::shared_future<Basis> answer;
  bool is_first = false;
  {
    const std::scoped_lock lock(mutex_);
    const auto [place, is_new] = known_.try_emplace(key, std::shared_future<Basis>());
    if (is_new) place->second = mine.get_future().share();
    answer = place->second;
    is_first = is_new;
  }
  if (is_first) {
    try {
      mine.set_value(growth(model, ladder, cancellation));
    } catch (...) {
      mine.set_exception(std::current_exception());
    }
  }
  return answer.get();
}

}  // namespace ramify
