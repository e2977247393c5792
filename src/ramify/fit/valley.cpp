#include "ramify/fit/valley.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ramify/optimise/profile.hpp"

namespace ramify {
namespace {

constexpr std::size_t steps = 24;

/// Of log(a+b) and log(b/a) >= 0, the logarithms of a and b.
Point shapes_at(std::span<const double> at) {
  const double log_a = at[0] - at[1] - std::log1p(std::exp(-at[1]));
  return {log_a, log_a + at[1]};
}

/// log(a+b) and log(b/a).
Point along_and_across(const Point& shapes) {
  const auto [low, high] = std::minmax(shapes[0], shapes[1]);
  return {high + std::log1p(std::exp(low - high)), high - low};
}

Objective along_valley(const Objective& of_shapes) {
  const auto evaluate = [of_shapes](std::span<const double> at, double& value, double* gradient) {
    const Point shapes = shapes_at(at);
    std::array<double, 2> slopes{};
    if (!of_shapes.contains(shapes) ||
        !of_shapes.evaluate(shapes, value, gradient == nullptr ? nullptr : slopes.data()))
      return false;
    if (gradient != nullptr) {
      const double share = 1 / (1 + std::exp(-at[1]));  // b/(a+b)
      gradient[0] = slopes[0] + slopes[1];
      gradient[1] = (1 - share) * slopes[1] - share * slopes[0];
    }
    return true;
  };
  const double low = of_shapes.low[0], high = of_shapes.high[1];
  return {evaluate, {low + std::log(2), 0}, {high + std::log(2), high - low}};
}

/// The best log(b/a) at a log(a+b); two valleys may meet at a = b.
double across(const Objective& objective, double along, double near) {
  const std::array<Point, 4> starts{Point{near}, {0.01}, {0.7}, {2}};
  const std::vector<Minimum> found = minima(held(objective, 0, along), starts);
  return found.empty() ? near : found.front().at[0];
}

ValleyStop end_stop(const ProfileEnd& end) {
  return {shapes_at(end.place), end.is_open ? ValleyPoint::Place::open_end : ValleyPoint::Place::end};
}

std::string percent_text(double part) {
  return fmt::format("{:.{}f} %", 100 * part, part < 0.1 ? 1 : 0);
}

}  // namespace

std::vector<ValleyStop> valley(const Objective& minus_log_likelihood, const Point& best) {
  const Objective objective = along_valley(minus_log_likelihood);
  const Minimum bottom = minimise(objective, along_and_across(best));
  const Point even{0};
  const auto [low, high] = profile_interval(objective, bottom, 0, rise_of_two, std::span(&even, 1));
  std::vector<ValleyStop> stops{end_stop(low)};
  const double begin = low.place[0], length = high.place[0] - begin;
  double off = low.place[1];
  for (std::size_t i = 1; i < steps; ++i) {
    const double along = begin + length * static_cast<double>(i) / static_cast<double>(steps);
    off = across(objective, along, off);
    stops.push_back({shapes_at(Point{along, off}), ValleyPoint::Place::between});
  }
  stops.push_back(end_stop(high));
  const auto beyond = std::ranges::find_if(
      stops, [&bottom](const ValleyStop& stop) { return along_and_across(stop.searched)[0] > bottom.at[0]; });
  stops.insert(beyond, {shapes_at(bottom.at), ValleyPoint::Place::estimate});
  return stops;
}

std::string valley_note(const FamilyFit& fit) {
  if (fit.family->mirror != Mirror::exchanged || !fit.horton_ratio) return {};
  const auto part = [](const FittedParameter& known) { return known.standard_error / known.estimate; };
  const double of_ratio = part(*fit.horton_ratio), of_a = part(fit.parameters[0]),
               of_b = part(fit.parameters[1]);
  if (!(of_ratio < std::min(of_a, of_b))) return {};
  return fmt::format(
      "R(a,b) is known to {}, a to {}, b to {}: --curve lists the pairs that fit nearly as well",
      percent_text(of_ratio), percent_text(of_a), percent_text(of_b));
}

}  // namespace ramify
