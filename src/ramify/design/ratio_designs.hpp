#pragma once

#include "ramify/io/table.hpp"
#include "ramify/optimise/scanned_curve.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Models whose limiting Horton ratio (horton_ratio_constant.hpp) is this: patricia(p) and split(p) of p =
/// 1/ratio, and the beta(a,b) of some means a/(a+b) from 1/2 down, of which every a+b from 0.01 to 200 is
/// found. Columns model, a, b, p, depth, height, horton_ratio.
///
/// Throws Error for a ratio below 2, Interrupted. Cost: some ten seconds on one core.
Table limiting_ratio_designs(double ratio, const ScanEffort& effort);

/// Models whose expected_pooled_ratio (pooled_ratio.hpp) at n is this: every p from 0.01 to 1/2 of
/// patricia(p) and dst(p), and the beta(a,b) of the same means. Columns model, n, a, b, p, depth, height,
/// streams_pooled_ratio.
///
/// Throws Error for a ratio below 2, for n below 3, and where no such model has the ratio at n, with the
/// ratios that they have; Interrupted. Cost: some ten seconds on one core to n = 10^3, a minute beyond.
Table finite_ratio_designs(double ratio, Size n, const ScanEffort& effort);

}  // namespace ramify
