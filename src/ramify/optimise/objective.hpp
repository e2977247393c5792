#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace ramify {

/// A place of parameter space.
using Point = std::vector<double>;

/// What is minimised: a function of a few parameters in a box, with its gradient.
///
/// evaluate(at, value, gradient) writes both, gradient only where it is not null; false where the function
/// has no finite value there. It is not called outside the box.
struct Objective {
  std::function<bool(std::span<const double> at, double& value, double* gradient)> evaluate;
  Point low, high;  ///< of the box; infinite where it has no end

  std::size_t parameters() const { return low.size(); }

  bool contains(std::span<const double> at) const {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] < low[i] || at[i] > high[i] || std::isnan(at[i])) return false;
    return true;
  }

  /// Infinity where there is none.
  double value(std::span<const double> at) const;
};

/// The same function with one parameter held.
Objective held(const Objective& objective, std::size_t parameter, double value);

}  // namespace ramify
