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
/// family's means m and covariances Sigma at n (1/12 on its diagonal, rounding_variance),
///
///     k/2 log 2 pi + 1/2 log det Sigma + 1/2 (M - m)' Sigma^-1 (M - m),
///
/// and minus log(P(S = s) + 1e-5) for the orders above, too sparse for a density. M_0 = n+1 carries nothing.
/// @param surface  of n = counts.n(); must outlive the objective
Objective count_objective(const CountSurface& surface, const ObservedCounts& counts);

/// What the likelihood says at one point.
struct CountFitness {
  double log_likelihood;
  double misfit;  ///< (M - m)' Sigma^-1 (M - m) over the orders of the reading
};

/// By the law at that point itself: nothing is read between others. Throws Interrupted. Cost: a law.
CountFitness count_fitness(const CountSurface& surface, const ObservedCounts& counts,
                           std::span<const double> searched);

/// The misfit alone, as the surface has it; NaN outside its chart.
double count_misfit(const CountSurface& surface, const ObservedCounts& counts,
                    std::span<const double> searched);

}  // namespace ramify
