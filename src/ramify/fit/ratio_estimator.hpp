#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

/// The bifurcation ratio of one tree, six ways: three estimators, each of stream and of node counts
/// (order_ratios.hpp).
enum class RatioEstimator : std::uint8_t {
  streams_mean_ratio,  ///< the one that is fitted
  streams_regression,  ///< what biologists print
  streams_geometric,
  nodes_mean_ratio,  ///< the thesis's definition (3.1.2)
  nodes_regression,
  nodes_geometric,
};

inline constexpr std::size_t ratio_estimator_count = 6;

/// One value for each RatioEstimator, in its order.
using RatioValues = std::array<double, ratio_estimator_count>;

constexpr std::size_t index_of(RatioEstimator estimator) {
  return static_cast<std::size_t>(estimator);
}

/// Ratios of the expected counts of streams, E M_k, by their law (law_ratios.hpp).
enum class LawEstimator : std::uint8_t {
  streams_pooled_ratio,         ///< (E M_0 + ... + E M_(K-1)) / (E M_1 + ... + E M_K)
  streams_regression_of_means,  ///< exp of minus the slope of log E M_k on k, orders weighted by P(S >= k)
};

inline constexpr std::size_t law_estimator_count = 2;

constexpr std::size_t index_of(LawEstimator estimator) {
  return static_cast<std::size_t>(estimator);
}

/// "streams_pooled_ratio"
std::string_view estimator_name(LawEstimator estimator);

/// "streams_mean_ratio"
std::string_view estimator_name(RatioEstimator estimator);

/// All six of one tree; NaN for a single external node. O(orders).
RatioValues ratio_values(const TreeMeasures& measures);

}  // namespace ramify
