#include "ramify/law/trim.hpp"

#include <algorithm>
#include <numeric>

#include "ramify/core/contract.hpp"

namespace ramify {

std::span<double> trim_to_law(std::vector<double>& weights, double negligible) {
  const auto kept = [negligible](double w) { return w >= negligible; };
  const auto begin = std::find_if(weights.begin(), weights.end(), kept);
  const auto end = std::find_if(weights.rbegin(), weights.rend(), kept).base();
  RAMIFY_EXPECTS(begin < end);
  const auto sum = static_cast<double>(std::accumulate(begin, end, 0.0L));
  std::for_each(begin, end, [sum](double& w) { w /= sum; });
  return {begin, end};
}

}  // namespace ramify
