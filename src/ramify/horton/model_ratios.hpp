#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/horton/order_range.hpp"
#include "ramify/horton/ratio_kind.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// Trees that are grown to see how a ratio scatters: replicates 0..trees-1 of the model's stream.
struct ModelTrees {
  std::uint64_t trees;
  std::uint64_t seed;
  unsigned threads;  ///< decides the time alone
};

/// How an estimator of the bifurcation ratio comes out in trees of a model.
struct ModelRatio {
  double mean;
  double deviation;  ///< of one tree: the standard error of an estimate from one
};

/// How bifurcation ratios of one tree scatter under a model of splitting trees, at its size.
///
/// By the law where every order has many streams: delta method on means and covariances of the counts
/// (large/stream_counts.hpp). By grafted trees where the highest orders, which are sparse, are read. Above
/// 2^20 nodes the trees have mean counts of their small subtrees (mean_counts.hpp), which leaves the sparse
/// orders as they are.
class ModelRatios {
 public:
  /// Grows the trees. A model tree's orders above the first that has fewer streams than the observed
  /// tree's highest are left out: a tree that was cut is held against trees that are cut alike.
  /// Throws Interrupted. Cost: a law, and some 3 ns a node.
  /// @param counts  observed, of orders 0..S; counts[0] - 1 internal nodes. The model has a law there.
  ModelRatios(const Model& model, std::span<const double> counts, const ModelTrees& plan,
              const Cancellation& cancellation);

  /// By grown trees, each with the range's own orders of its own.
  ModelRatio by_trees(RatioKind kind, OrderRange range) const;
  /// By the law, of given orders; the mean is the ratio of mean counts.
  ModelRatio by_law(RatioKind kind, OrderSpan orders) const;

  /// (E M_0 + ... + E M_(K-1)) / (E M_1 + ... + E M_K), over all orders that trees can have.
  double pooled_means() const;

  /// Orders k whose ratio of counts k to k+1 is none of the model's: log M_k/M_(k+1) is farther from its
  /// mean, in its own standard deviations, than the farthest of all orders is in 95 % of the trees (so it is
  /// simultaneous). Ascending. An order that fewer than 40 trees have is not judged.
  std::vector<std::size_t> outlying() const;

 private:
  struct LogRatio {
    double mean, deviation;
  };
  std::vector<LogRatio> log_ratios() const;
  LogRatio log_ratio_by_law(std::size_t k) const;

  StreamCounts law_;
  std::vector<double> counts_;
  std::vector<std::vector<double>> trees_;  // counts of every tree
};

}  // namespace ramify
