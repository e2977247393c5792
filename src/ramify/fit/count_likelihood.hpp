#pragma once

#include <cstdint>
#include <vector>

#include "ramify/fit/count_surface.hpp"
#include "ramify/optimise/objective.hpp"

namespace ramify {

/// The number of streams of every order of one binary tree, from the leaf order up.
struct ObservedCounts {
  std::vector<std::uint64_t> streams;

  Size n() const { return streams.front() - 1; }
  std::size_t top() const { return streams.size() - 1; }  ///< S, leaf order 0

  /// What a likelihood of the counts reads: the orders whose order below has `enough` streams, so that
  /// whether an order is used does not depend on its own count, and the order of the tree.
  CountReading reading() const;
  static constexpr std::uint64_t enough = 30;
};

/// Minus the log of the likelihood of stream counts, given n: the Gaussian density of M_1, ..., M_k with the
/// family's means and covariances at n,
///
///     k/2 log 2 pi + 1/2 log det Sigma + 1/2 (M - m)' Sigma^-1 (M - m),
///
/// and minus log P(S = s) for the orders above, too sparse for a density. M_0 = n+1 carries nothing.
/// @param surface  of n = counts.n(); must outlive the objective
Objective count_objective(const CountSurface& surface, const ObservedCounts& counts);

/// (M - m)' Sigma^-1 (M - m) over the orders of the reading: chi-square with as many degrees of freedom, but
/// for the parameters, where the family is right and counts are Gaussian.
double count_misfit(const CountSurface& surface, const ObservedCounts& counts,
                    std::span<const double> searched);

}  // namespace ramify
