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

/// How the count of an order scatters about what the orders below it let expect, in standard deviations z
/// (L z = M - m, L Cholesky's factor of Sigma).
enum class CountDensity {
  gaussian,  ///< exp(-z^2/2) / sqrt(2 pi)
  huber,     ///< exp(-rho(z^2)/2) / c: Gaussian up to huber_scale, exponential tails beyond
};

/// Huber's k: of Gaussian counts 95 % of the information is kept (Huber 1964; Holland and Welsch 1977).
inline constexpr double huber_scale = 1.345;

/// Minus the log of the likelihood of stream counts, given n: the Gaussian density of M_1, ..., M_k with the
/// family's means m and covariances Sigma at n (1/12 on its diagonal, rounding_variance),
///
///     k/2 log 2 pi + 1/2 log det Sigma + 1/2 (M - m)' Sigma^-1 (M - m),
///
/// and minus log(P(S = s) + 1e-5) for the orders above, too sparse for a density. M_0 = n+1 carries nothing.
/// Of CountDensity::huber z^2 in the misfit and 2 pi are replaced by ceres::HuberLoss and what the density
/// then integrates to: a proper likelihood still, in which one odd order costs in proportion to its distance.
/// @param surface  of n = counts.n(); must outlive the objective
Objective count_objective(const CountSurface& surface, const ObservedCounts& counts,
                          CountDensity density = CountDensity::gaussian);

/// What the likelihood says at one point.
struct CountFitness {
  double log_likelihood;
  double misfit;                  ///< (M - m)' Sigma^-1 (M - m) over the orders of the reading
  std::vector<double> residuals;  ///< z of the orders 1, 2, ..: their squares sum to it
};

/// By the law at that point itself: nothing is read between others. Throws Interrupted. Cost: a law.
CountFitness count_fitness(const CountSurface& surface, const ObservedCounts& counts,
                           std::span<const double> searched, CountDensity density = CountDensity::gaussian);

/// The misfit alone, as the surface has it; NaN outside its chart.
double count_misfit(const CountSurface& surface, const ObservedCounts& counts,
                    std::span<const double> searched);

}  // namespace ramify
