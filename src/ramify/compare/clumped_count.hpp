#pragma once

namespace ramify {

/// How far a total count of clumps lies from its mean: the z that a normal variate goes beyond, on the same
/// side, as rarely as the total goes as far; above the mean positive, and 0 where at least half of all totals
/// go as far.
///
/// What few trees have, they have in clumps: the nodes of the highest order come as a stream of them, whose
/// length is nearly geometric. The total of many trees is taken for a Poisson number of clumps of geometric
/// sizes 1, 2, ... (Polya-Aeppli; Johnson, Kemp, Kotz 2005, 9.7) with its mean and variance; for Poisson
/// where the variance is below the mean. P(X = x) by x P(x) = (l (1-r) + 2 r (x-1)) P(x-1) - r^2 (x-2) P(x-2)
/// with variance/mean = (1+r)/(1-r) and l = mean (1-r). Not beyond 37.5, where doubles end.
///
/// @param total  of all trees together
/// @param mean  its expectation, 0 at least
/// @param variance  its variance, mean^2/largest_clump_ratio at least
/// O(total + mean + some standard deviations) time.
double clumped_count_z(double total, double mean, double variance);

/// Above this mean^2/variance, which is some number of clumps or half of it, normal tails do: at one in a
/// million they are off by a factor of four at most.
inline constexpr double largest_clump_ratio = 300;

}  // namespace ramify
