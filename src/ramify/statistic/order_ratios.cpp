#include "ramify/statistic/order_ratios.hpp"

#include <cmath>
#include <limits>

#include "ramify/estimate/centred_slope.hpp"

namespace ramify {

OrderRatios order_ratios(std::span<const std::uint64_t> counts) {
  if (counts.size() < 2) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none};
  }
  const double top = static_cast<double>(counts.size() - 1);
  double sum_of_ratios = 0;
  CentredSlope slope(top / 2);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double count = static_cast<double>(counts[k]);
    if (k + 1 < counts.size()) sum_of_ratios += count / static_cast<double>(counts[k + 1]);
    slope.add(static_cast<double>(k), std::log(count));
  }
  const double ends = static_cast<double>(counts.front()) / static_cast<double>(counts.back());
  return {sum_of_ratios / top, std::exp(-slope.value()), std::pow(ends, 1 / top)};
}

}  // namespace ramify
