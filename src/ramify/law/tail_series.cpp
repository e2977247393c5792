#include "ramify/law/tail_series.hpp"

#include <algorithm>

#include <Eigen/Core>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double rounded_away = 0x1p-54;

/// The entries begin..end-1 of what starts with the entry `first`.
auto between(const double* values, Size first, Size begin, Size end) {
  return Eigen::Map<const Eigen::ArrayXd>(values + (begin - first), static_cast<Eigen::Index>(end - begin));
}

}  // namespace

void TailSeries::append(double probability) {
  if (likely_ == sizes() && probability < rounded_away) ++likely_;
  if (values_.empty() && probability == 0)
    ++first_;
  else
    values_.push_back(probability);
}

double over_either_child(const SplitRow& row, const TailSeries& event) {
  RAMIFY_EXPECTS(event.sizes() >= row.n);
  // Sizes i of the smaller child: from `apart` on the two events happen together often enough to matter.
  const Size begin = row.first, end = row.first + row.weights.size();
  const Size apart = std::clamp(event.likely_, begin, end);
  const auto weights = [&](Size from, Size to) { return between(row.weights.data(), row.first, from, to); };
  const auto smaller = [&](Size from, Size to) {
    return between(event.values_.data(), event.first_, from, to);
  };
  const auto larger = [&](Size from, Size to) { return smaller(row.n - to, row.n - from).reverse(); };
  double sum = 0;
  if (apart < end) {
    const auto both = smaller(apart, end);
    sum += (weights(apart, end) * (both + larger(apart, end) * (1 - both))).sum();
  }
  const Size first = std::max(begin, event.first_);
  if (first < apart) sum += (weights(first, apart) * smaller(first, apart)).sum();
  const Size last = std::min(apart, row.n - std::min(row.n, event.first_));
  if (begin < last) sum += (weights(begin, last) * larger(begin, last)).sum();
  return sum;
}

}  // namespace ramify
