#include "ramify/design/depth_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/design/design_row.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/optimise/root_between.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/height_constant.hpp"

namespace ramify {
namespace {

constexpr Domain shapes = beta_shape("a").domain;
constexpr double largest_depth = 1e8;  // above, a would fall below its domain somewhere on the curve

/// Within the domain of a and b 50 digits always do.
double known(const std::optional<Rounded>& constant) {
  RAMIFY_EXPECTS(constant);
  return constant->value;
}

double depth_of(double a, double b) {
  return known(beta_depth({a, b}));
}

BinarySplit fixed(double x) {
  return BinarySplit(ConstantFraction{x, Scatter::none});
}

/// Falls in x: the root of function(x) = target, searched on a logarithmic scale.
template <class Function>
double inverse(const Function& function, double target, double low, double high) {
  return std::exp(
      root_between([&](double x) { return function(std::exp(x)) - target; }, std::log(low), std::log(high)));
}

double checked(double depth) {
  const std::string problem = fmt::format("--depth {}", depth);
  if (!(depth > 1 / std::numbers::ln2))
    throw Error(problem, "depth constants of beta trees are above 1/log 2 = 1.442695, that of perfect halves",
                "take a larger one");
  const double least = depth_of(shapes.high, shapes.high);
  if (depth < least)
    throw Error(problem, fmt::format("it takes a and b above {:g}", shapes.high),
                fmt::format("take {} or more", format_exact(least)));
  if (depth > largest_depth)
    throw Error(problem, fmt::format("it is searched for up to {:g}", largest_depth), "take a smaller one");
  return depth;
}

double symmetric_shape(double depth) {
  const auto of_symmetric = [](double a) { return depth_of(a, a); };
  if (of_symmetric(shapes.high) == depth) return shapes.high;
  return inverse(of_symmetric, depth, shapes.low, shapes.high);
}

/// The beta(a,b) of a depth, a <= b.
BetaSplit split_at(double depth, double b) {
  if (depth_of(b, b) >= depth) return {b, b};  // where the curve begins, but for rounding
  return {inverse([b](double a) { return depth_of(a, b); }, depth, shapes.low, b), b};
}

/// Values of b: close together where b - a is about 1 and where b begins to outgrow a, for the extrema lie
/// there; some beyond, where the curve nears its end like 1/b.
std::vector<double> scan_grid(double symmetric) {
  std::vector<double> grid;
  for (const double above : {0.0, 0.25, 0.5, 0.75, 1.0}) grid.push_back(symmetric + above);
  const auto add = [&](double from, double to, double a_decade) {
    const double step = std::pow(10, 1 / a_decade);
    for (double b = from; b < to; b *= step) grid.push_back(b);
  };
  const double dense = 30 * symmetric, sparse = std::max(1e4 * symmetric, 1e4);
  add(symmetric, dense, 12);
  add(dense, sparse, 6);
  add(sparse, shapes.high, 1);
  grid.push_back(shapes.high);
  std::erase_if(grid, [](double b) { return b > shapes.high; });
  std::ranges::sort(grid);
  grid.erase(std::ranges::unique(grid).begin(), grid.end());
  return grid;
}

}  // namespace

DepthCurve::DepthCurve(double depth, const ScanEffort& effort)
    : depth_(checked(depth)),
      symmetric_(symmetric_shape(depth)),
      curve_([depth](double b) { return known(beta_height(split_at(depth, b))); }, scan_grid(symmetric_),
             effort),
      end_fraction_(
          inverse([](double x) { return known(fixed_depth(fixed(x))); }, depth, 1e-3 / largest_depth, 0.5)),
      end_height_(known(fixed_height(fixed(end_fraction_)))) {}

std::vector<BetaSplit> DepthCurve::splits() const {
  std::vector<BetaSplit> splits;
  for (const auto& point : curve_.points()) splits.push_back(split_at(depth_, point.x));
  return splits;
}

HeightRange DepthCurve::heights() const {
  const auto end_at = [this](const ScannedCurve::Point& found, bool is_beyond) {
    return is_beyond ? HeightEnd{end_height_, std::nullopt} : HeightEnd{found.y, split_at(depth_, found.x)};
  };
  const auto lowest = curve_.lowest(), highest = curve_.highest();
  return {end_at(lowest, end_height_ < lowest.y), end_at(highest, end_height_ > highest.y)};
}

std::vector<BetaSplit> DepthCurve::with_height(double height) const {
  std::vector<BetaSplit> splits;
  for (const double b : curve_.solutions(height)) {
    const BetaSplit split = split_at(depth_, b);
    splits.push_back({to_design_digits(split.a), to_design_digits(split.b)});
  }
  return splits;
}

}  // namespace ramify
