#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/fit/ratio_estimator.hpp"
#include "ramify/model/model_info.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// One estimator over trees of one (p, n).
struct ResponseSummary {
  double mean;
  double standard_error;  ///< of the mean
  double low;             ///< 2.5 % quantile of one tree
  double high;            ///< 97.5 % quantile of one tree
};

/// What trees of one p look like at the surface's n.
struct ResponsePoint {
  double p;
  std::uint64_t trees;
  std::array<ResponseSummary, ratio_estimator_count> summary;

  const ResponseSummary& operator[](RatioEstimator estimator) const { return summary[index_of(estimator)]; }
};

/// A wish: so many trees at p, replicates 0..trees-1 of the model's stream.
struct ResponseRequest {
  double p;
  std::uint64_t trees;
};

/// The expected ratio of trees of a model of one parameter p, as a function of it, by simulation.
///
/// E mean_ratio is no function of the mean counts (it is a mean of quotients within a tree), so there is
/// nothing to compute it from but trees.
class ResponseSurface {
 public:
  /// @param model    one that require_fittable accepts (ratio_fitter.hpp): the law of p is the mirror image
  /// of
  ///                 that of 1-p
  /// @param n        internal nodes, >= 1
  /// @param threads  >= 1; decides the time alone
  ResponseSurface(const ModelInfo& model, Size n, std::uint64_t seed, unsigned threads,
                  const Cancellation& cancellation);

  Size n() const { return n_; }

  /// One point for each request. A tree depends on (seed, model, p, n, replicate) alone. Throws Interrupted.
  /// Cost: sum of trees * n nodes, about 3 ns each to largest_counted; above it some ms a tree, and the
  /// table of each p (MeanCountsTable).
  std::vector<ResponsePoint> sample(std::span<const ResponseRequest> requests) const;

  /// The grid on which the curve is first seen: p in [lowest_p, 1/2], ascending.
  std::vector<double> grid() const;

  /// Distance of neighbouring grid points in log p, near p. The mean ratio swings with the order
  /// S ~ log n / log(1/p); a period is log(1/p)^2 / log n wide, and gets six points at least.
  double grid_step(double p) const;

  static constexpr double lowest_p = 0.01;

 private:
  const ModelInfo* model_;
  Size n_;
  std::uint64_t seed_;
  unsigned threads_;
  const Cancellation* cancellation_;
};

/// Mean, standard error and central 95 % of each column. @param rows  one for each tree, two at least
std::array<ResponseSummary, ratio_estimator_count> summarise(std::span<const RatioValues> rows);

}  // namespace ramify
