#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ramify/core/wide.hpp"

namespace ramify {

/// One row of an alias table: a column of the square histogram (Walker 1977, Vose 1991).
struct AliasCell {
  std::uint64_t threshold;  ///< keep the column while the fraction is below threshold / 2^64
  std::uint32_t other;      ///< else this outcome
};

/// Fills cells with the alias table of the weights.
///
/// @param weights  >= 0, finite, positive sum; normalised here. Length m, 1 <= m < 2^32
/// @param cells    m cells; outcome i is drawn with probability weights[i] / sum to within 2^-53
/// Cost O(m).
void build_alias_cells(std::span<const double> weights, std::span<AliasCell> cells);

/// One draw: one word of the stream, O(1).
template <class Urbg>
std::uint64_t draw_alias(std::span<const AliasCell> cells, Urbg& stream) {
  const WideProduct product = multiply_wide(stream(), cells.size());
  const AliasCell& cell = cells[product.high];
  // Which of the two is a coin toss that no branch predictor guesses: take it without a branch.
  const std::uint64_t keep = 0 - static_cast<std::uint64_t>(product.low < cell.threshold);
  const std::uint64_t other = cell.other;
  return other ^ ((product.high ^ other) & keep);
}

}  // namespace ramify
