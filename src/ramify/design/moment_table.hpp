#pragma once

#include "ramify/io/table.hpp"
#include "ramify/theory/beta_split.hpp"

namespace ramify {

/// The beta(a,b) whose split fraction has this mean m and variance v: a = m s, b = (1-m) s,
/// s = m (1-m)/v - 1 (C8); a and b to 12 digits.
///
/// Throws Error unless 0 < m < 1 and 0 < v < m (1-m), and where a or b leaves its domain.
BetaSplit split_of_moments(double mean, double variance);

/// model, a, b, mean, variance, depth, height of it.
Table moment_table(double mean, double variance);

}  // namespace ramify
