#include "ramify/law/node_sum_law.hpp"

#include <array>

#include "ramify/core/contract.hpp"

namespace ramify {

NodeSumLaw::NodeSumLaw(NodeSum sum) : toll_(sum.toll), child_weight_(sum.averaged ? 0.5 : 1) {
  mean_.append(0);
  variance_.append(0);
}

void NodeSumLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes_);
  double mean = 0, variance = 0;
  given_.clear();
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const Size smaller = row.smaller(m), larger = row.larger(m);
    given_.push_back(child_weight_ * (mean_[smaller] + mean_[larger]) +
                     toll_(std::array{static_cast<double>(smaller + 1), static_cast<double>(larger + 1)}));
    mean += row.weights[m] * given_.back();
  }
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const double deviation = given_[m] - mean;
    variance += row.weights[m] * deviation * deviation;
  }
  variance += child_weight_ * child_weight_ * over_children(row, variance_);
  mean_.append(mean);
  variance_.append(variance);
  ++sizes_;
}

}  // namespace ramify
