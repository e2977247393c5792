#include "ramify/law/depth_moments.hpp"

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// The mean of f(i) over the child of size i that the walk goes to.
template <class F>
double over_children(const SplitRow& row, F f) {
  double sum = 0;
  for (std::size_t m = 0; m < row.weights.size(); ++m) {
    const Size a = row.smaller(m), b = row.larger(m);
    sum += row.weights[m] * (static_cast<double>(a) * f(a) + static_cast<double>(b) * f(b));
  }
  return sum / static_cast<double>(row.n - 1);
}

}  // namespace

void DepthMoments::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes());
  if (row.n == 1) {
    moments_.push_back({1, 0});
    return;
  }
  const double mean = 1 + over_children(row, [this](Size i) { return moments_[i].mean; });
  const double variance = over_children(row, [this, mean](Size i) {
    const double deviation = 1 + moments_[i].mean - mean;
    return moments_[i].variance + deviation * deviation;
  });
  moments_.push_back({mean, variance});
}

}  // namespace ramify
