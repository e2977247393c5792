#include "ramify/law/order_means.hpp"

namespace ramify {

OrderMeans::OrderMeans(Size largest_n)
    : strahler_(largest_n), stride_(HortonStrahler::largest_order(largest_n) + 1) {
  for (auto* table : {&nodes_, &streams_}) {
    table->reserve((largest_n + 1) * stride_);
    table->resize(stride_, 0.0);
    table->front() = 1;
  }
}

void OrderMeans::extend(const SplitRow& row) {
  std::vector<double> nodes(stride_, 0.0), streams(stride_, 0.0);
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const double weight = row.weights[m];
    const std::size_t a = row.smaller(m) * stride_, b = row.larger(m) * stride_;
    const double* at_a = strahler_.law(row.smaller(m)).at;
    const double* at_b = strahler_.law(row.larger(m)).at;
    for (std::size_t k = 0; k < stride_; ++k) {
      const auto below = static_cast<std::ptrdiff_t>(k) - 1;
      nodes[k] += weight * (nodes_[a + k] + nodes_[b + k]);
      streams[k] += weight * (streams_[a + k] + streams_[b + k] + at_a[below] * at_b[below]);
    }
  }
  strahler_.extend(row);
  const auto root = strahler_.pmf(row.n);
  for (std::size_t k = 0; k < stride_; ++k) nodes[k] += root[k];
  // Exact; summed over n levels it would drift by an ulp each.
  nodes[0] = streams[0] = static_cast<double>(row.n + 1);
  nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  streams_.insert(streams_.end(), streams.begin(), streams.end());
}

}  // namespace ramify
