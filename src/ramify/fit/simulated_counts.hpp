#pragma once

#include <cstdint>
#include <string>

#include "ramify/core/cancellation.hpp"
#include "ramify/family/family.hpp"
#include "ramify/large/stream_counts.hpp"

namespace ramify {

/// Internal nodes of a family's tree with as many tips as a binary tree of n internal nodes: n, and n/2 where
/// all forks are of three (one tip fewer, where n is odd).
Size size_with_tips_of(const Family& family, Size n);

/// How many trees a simulation takes at each place: 2,000, or fewer that have 5 10^7 nodes together, 200 at
/// least.
std::uint64_t simulated_trees(Size n);

/// Nothing where a family's counts can be simulated at n; else why not.
std::string cannot_simulate(Size n);

/// What stream_counts() says, of a family without a law (Family::is_simulated), by trees that are grown:
/// means and covariances of the sample, and the law of the order with half a tree added to each order.
///
/// The random numbers are the same whatever the parameters, so that what differs between two is the
/// parameters' more than chance's. Means err by 1/sqrt(trees) of one tree's standard deviation. One thread.
/// Throws Interrupted. Cost: some 50 ns a node.
/// @param n  of the binary tree with as many tips
StreamCounts simulated_stream_counts(const Family& family, std::span<const double> values, Size n,
                                     const Cancellation& cancellation);

}  // namespace ramify
