#include "ramify/law/size_series.hpp"

#include <algorithm>

#include <Eigen/Core>

namespace ramify {
namespace {

Eigen::Map<const Eigen::ArrayXd> view(const double* first, Size count) {
  return {first, static_cast<Eigen::Index>(count)};
}

}  // namespace

void SizeSeries::append(double value) {
  if (value != 0) {
    if (first_ > last_) first_ = values_.size();
    last_ = values_.size();
  }
  values_.push_back(value);
}

double over_children(const SplitRow& row, const SizeSeries& a, const SizeSeries& b) {
  const Size others = row.n - 1;
  if (row.weights.empty() || a.first_ > a.last_ || b.first_ > b.last_ || b.first_ > others) return 0;
  const Size low = std::max({a.first_, b.last_ >= others ? 0 : others - b.last_, row.first});
  const Size high = std::min({a.last_, others - b.first_, row.first + row.weights.size() - 1});
  if (low > high) return 0;
  const Size length = high - low + 1;
  return (view(row.weights.data() + (low - row.first), length) * view(a.values_.data() + low, length) *
          view(b.values_.data() + (others - high), length).reverse())
      .sum();
}

double over_children(const SplitRow& row, const SizeSeries& a) {
  const Size length = row.weights.size(), last = row.first + length - 1;
  return (view(row.weights.data(), length) * (view(a.values_.data() + row.first, length) +
                                              view(a.values_.data() + (row.n - 1 - last), length).reverse()))
      .sum();
}

}  // namespace ramify
