#include "ramify/compare/holm.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace ramify {

std::vector<double> holm_adjusted(const std::vector<double>& p_values) {
  std::vector<std::size_t> ascending(p_values.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::sort(ascending.begin(), ascending.end(),
            [&](std::size_t a, std::size_t b) { return p_values[a] < p_values[b]; });
  std::vector<double> adjusted(p_values.size());
  double least = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const double factor = static_cast<double>(ascending.size() - i);
    least = std::max(least, std::min(1.0, factor * p_values[ascending[i]]));
    adjusted[ascending[i]] = least;
  }
  return adjusted;
}

}  // namespace ramify
