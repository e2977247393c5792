#include "ramify/law/node_sum_law.hpp"

#include "ramify/core/contract.hpp"

namespace ramify {

NodeSumLaw::NodeSumLaw(Of of) : of_(of) {
  mean_.append(0);
  variance_.append(0);
}

double NodeSumLaw::cost(const SplitRow& row, std::size_t m) const {
  switch (of_) {
    case Of::path_length:
      return static_cast<double>(row.n - 1);
    case Of::sackin:
      return static_cast<double>(row.n + 1);
    case Of::colless:
      break;
  }
  return static_cast<double>(row.larger(m) - row.smaller(m));
}

void NodeSumLaw::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes_);
  const auto given = [&](std::size_t m) {
    return mean_[row.smaller(m)] + mean_[row.larger(m)] + cost(row, m);
  };
  double mean = 0, variance = 0;
  for (std::size_t m = 0; m < row.weights.size(); ++m) mean += row.weights[m] * given(m);
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const double deviation = given(m) - mean;
    variance += row.weights[m] * deviation * deviation;
  }
  variance += over_children(row, variance_);
  mean_.append(mean);
  variance_.append(variance);
  ++sizes_;
}

}  // namespace ramify
