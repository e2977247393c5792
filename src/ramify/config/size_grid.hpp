#pragma once

#include <cstddef>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Sizes of a grid: at most this many.
inline constexpr std::size_t max_grid_sizes = 10'000;

/// from, ..., to: round(from (to/from)^(j/(count-1))), j = 0..count-1, equal neighbours once.
///
/// Computed with 50 digits, so the sizes are the same on every machine. 1 <= from < to <= 2^62 and 2 <= count
/// <= max_grid_sizes, or from = to and count = 1; Error otherwise.
std::vector<Size> geometric_grid(Size from, Size to, std::size_t count);

/// Sizes of one phase of an oscillation: round(from factor^j), j = 0..count-1, equal neighbours once.
///
/// @param factor  finite, above 1: 4 for catalan, 1/p for patricia(p)
/// from >= 1, 1 <= count <= max_grid_sizes; Error otherwise, and where a size passes 2^62.
std::vector<Size> scaled_grid(Size from, double factor, std::size_t count);

}  // namespace ramify
