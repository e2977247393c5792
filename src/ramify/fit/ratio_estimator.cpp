#include "ramify/fit/ratio_estimator.hpp"

#include <span>

#include "ramify/statistic/order_ratios.hpp"

namespace ramify {

std::string_view estimator_name(RatioEstimator estimator) {
  static constexpr std::array<std::string_view, ratio_estimator_count> names{
      "streams_mean_ratio", "streams_regression", "streams_geometric",
      "nodes_mean_ratio",   "nodes_regression",   "nodes_geometric"};
  return names[index_of(estimator)];
}

std::string_view estimator_name(LawEstimator estimator) {
  static constexpr std::array<std::string_view, law_estimator_count> names{"streams_pooled_ratio",
                                                                           "streams_regression_of_means"};
  return names[index_of(estimator)];
}

RatioValues ratio_values(const TreeMeasures& measures) {
  const std::size_t orders = measures.strahler + std::size_t{1};
  const OrderRatios streams = order_ratios(std::span(measures.streams).first(orders));
  const OrderRatios nodes = order_ratios(std::span(measures.nodes).first(orders));
  return {streams.mean_ratio, streams.regression, streams.geometric,
          nodes.mean_ratio,   nodes.regression,   nodes.geometric};
}

}  // namespace ramify
