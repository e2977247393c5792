#pragma once

#include <span>
#include <string>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// What a model expects of the stream counts M_k of its trees of one size, leaf order 0.
struct StreamMeans {
  std::vector<double> means;       ///< E M_k, k = 0..K, K = floor(log2(n+1))
  std::vector<double> order_tail;  ///< P(S >= s), s = 0..K+1

  std::size_t orders() const { return means.size(); }
};

/// And how they scatter.
struct StreamCounts : StreamMeans {
  std::vector<double> covariances;  ///< Cov(M_j, M_k), row by row

  double covariance(std::size_t j, std::size_t k) const { return covariances[j * orders() + k]; }

  /// The standard deviation of the sum of weights[k] M_k, k = 0..orders()-1: with the slopes of a function of
  /// the counts for weights that of the function, by the delta method.
  double deviation(std::span<const double> weights) const;
};

/// (E M_0 + E M_1 + ... - 1) / (E M_1 + E M_2 + ...): numerator and denominator are the expectations of those
/// of the pooled ratio of one tree, whose highest order has one stream. Two orders at least.
double pooled_ratio_of_means(std::span<const double> means);

/// Nothing where stream_counts has an answer; else why it has none.
std::string no_stream_counts(const Model& model, Size n);

/// E M_k, Cov(M_j, M_k) and the law of S of a split model at n: what a fit asks for at parameter after
/// parameter.
///
/// Exact to 272; beyond on one grid of sizes that begins at 256 (later for a lopsided binomial split),
/// without the second and third solution by which LargeOrders tells its errors: means are right to 2e-3
/// standard deviations of one tree, covariances of M_j and M_k to 2e-3 of their standard deviations' product,
/// as tests/exact/stream_counts_test.cpp holds against LargeOrders. Cost: 0.01 s to n = 272, 0.02 to 0.2 s to
/// 10^9.
///
/// Throws Error where no_stream_counts gives a reason, Interrupted.
StreamCounts stream_counts(const Model& model, Size n, const Cancellation& cancellation = {});

/// The same without covariances, at a quarter of the cost.
StreamMeans stream_means(const Model& model, Size n, const Cancellation& cancellation = {});

}  // namespace ramify
