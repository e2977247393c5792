#include "ramify/random/alias_table.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

std::uint64_t to_threshold(double fraction) {
  constexpr double two_64 = 0x1p64;
  return fraction >= 1 ? UINT64_MAX : static_cast<std::uint64_t>(fraction * two_64);
}

}  // namespace

void build_alias_cells(std::span<const double> weights, std::span<AliasCell> cells) {
  RAMIFY_EXPECTS(!weights.empty() && weights.size() == cells.size());
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  RAMIFY_EXPECTS(sum > 0);
  const double scale = static_cast<double>(weights.size()) / sum;
  std::vector<double> height(weights.size());
  std::vector<std::uint32_t> below, above;
  for (std::uint32_t i = 0; i < weights.size(); ++i) {
    height[i] = weights[i] * scale;
    (height[i] < 1 ? below : above).push_back(i);
  }
  while (!below.empty() && !above.empty()) {
    const std::uint32_t small = below.back(), large = above.back();
    below.pop_back();
    cells[small] = {to_threshold(height[small]), large};
    height[large] -= 1 - height[small];
    if (height[large] < 1) {
      above.pop_back();
      below.push_back(large);
    }
  }
  // What is left has height 1 up to rounding. An outcome of weight 0 may be among it: the heaviest outcome
  // takes what is missing, so that it stays impossible.
  const auto heaviest = static_cast<std::uint32_t>(
      std::distance(weights.begin(), std::max_element(weights.begin(), weights.end())));
  for (const auto& rest : {below, above})
    for (const std::uint32_t i : rest) cells[i] = {to_threshold(height[i]), heaviest};
}

}  // namespace ramify
