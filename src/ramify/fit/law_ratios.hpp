#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/fit/ratio_estimator.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/model/model_info.hpp"
#include "ramify/optimise/scanned_curve.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The estimator of the expected counts. NaN where only one order is reached.
double law_ratio(LawEstimator estimator, const StreamMeans& counts);

/// The standard deviation, over single trees, of the same estimator of a tree's own counts: delta method on
/// their covariances. Right where the orders that it rests on have many streams.
double law_ratio_deviation(LawEstimator estimator, const StreamCounts& counts);

/// An estimator at one p.
struct LawRatio {
  double value;
  double deviation;  ///< of the ratio over single trees
};

/// A parameter p at which the estimator is the observed ratio.
struct LawRoot {
  double p;
  double deviation;  ///< of p over trees of it: that of the ratio over the slope of the curve, delta method
};

/// Ratios of expected counts as functions of the parameter p of a model, at one n. Nothing is sampled.
class LawRatios {
 public:
  /// @param model  of one parameter p
  /// @param grid   of p, ascending; at every one of them the model has laws at n (no_stream_counts)
  /// @param threads  decides the time alone
  /// Throws Interrupted. Cost: stream_means at each p of the grid.
  LawRatios(const ModelInfo& model, Size n, const std::vector<double>& grid, unsigned threads,
            const Cancellation& cancellation);

  LawRatios(const LawRatios&) = delete;  // its curves refer to it
  LawRatios& operator=(const LawRatios&) = delete;
  LawRatios(LawRatios&&) = delete;
  LawRatios& operator=(LawRatios&&) = delete;
  ~LawRatios() = default;

  /// Ascending. Throws Interrupted. Cost: some ten stream_means a root, and stream_counts.
  std::vector<LawRoot> roots(LawEstimator estimator, double observed) const;

  double value(LawEstimator estimator, double p) const;
  /// And how it scatters. Cost: stream_counts.
  LawRatio at(LawEstimator estimator, double p) const;
  /// The lowest and highest value for p in the range of the grid.
  std::pair<double, double> range(LawEstimator estimator) const;

 private:
  ScannedCurve curve(LawEstimator estimator, const std::vector<double>& grid, unsigned threads) const;

  const ModelInfo* model_;
  Size n_;
  const Cancellation* cancellation_;
  std::map<double, StreamMeans> known_;  ///< of the grid
  std::vector<ScannedCurve> curves_;     ///< of every LawEstimator, in its order
};

}  // namespace ramify
