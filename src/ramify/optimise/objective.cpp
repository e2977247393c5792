#include "ramify/optimise/objective.hpp"

#include <cmath>
#include <limits>

namespace ramify {
namespace {

Point without(Point point, std::size_t parameter) {
  point.erase(point.begin() + static_cast<std::ptrdiff_t>(parameter));
  return point;
}

}  // namespace

double Objective::value(std::span<const double> at) const {
  double found = 0;
  if (!contains(at) || !evaluate(at, found, nullptr) || !std::isfinite(found))
    return std::numeric_limits<double>::infinity();
  return found;
}

Objective held(const Objective& objective, std::size_t parameter, double value) {
  const auto evaluate = [inner = objective.evaluate, parameter, value](std::span<const double> at,
                                                                       double& found, double* gradient) {
    Point whole(at.begin(), at.end());
    whole.insert(whole.begin() + static_cast<std::ptrdiff_t>(parameter), value);
    Point slopes(whole.size());
    if (!inner(whole, found, gradient == nullptr ? nullptr : slopes.data())) return false;
    for (std::size_t i = 0, j = 0; gradient != nullptr && i < whole.size(); ++i)
      if (i != parameter) gradient[j++] = slopes[i];
    return true;
  };
  return {evaluate, without(objective.low, parameter), without(objective.high, parameter)};
}

}  // namespace ramify
