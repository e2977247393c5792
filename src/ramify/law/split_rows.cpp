#include "ramify/law/split_rows.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/law/trim.hpp"

namespace ramify {
namespace {

constexpr double dropped_below = 1e-30;
constexpr double read_back_nanoseconds = 4;  // of an entry
constexpr double far_below = 1e-40;  // of the mode of a binomial law: P(K = 0) may be nearly all of it

/// The windows of a law, or what its class Rows makes faster.
template <class Law>
std::function<WeightWindow(Size)> row_maker(const Law& law) {
  if constexpr (requires { typename Law::Rows; }) {
    return [rows = typename Law::Rows(law)](Size n) mutable { return rows.window(n); };
  } else {
    return [law](Size n) { return law.window(n, far_below); };
  }
}

}  // namespace

SplitRows::SplitRows(const Model& model)
    : left_(std::visit([](const auto& law) { return row_maker(law); }, model.law())) {}

SplitRow SplitRows::row(Size n) {
  RAMIFY_EXPECTS(n >= 1);
  fold(n, n == 1 ? WeightWindow{0, {1.0}} : left_(n));
  const auto kept = trim_to_law(weights_, dropped_below);
  return {n, smallest_ + static_cast<Size>(kept.data() - weights_.data()), kept};
}

/// Puts i and n-1-i together.
void SplitRows::fold(Size n, const WeightWindow& left) {
  const Size first = left.first, last = first + left.weights.size() - 1;
  smallest_ = std::min(first, n - 1 - last);
  const Size largest = std::max(std::min(first, n - 1 - first), std::min(last, n - 1 - last));
  const Size middle = (n - 1) / 2;
  const bool crosses = first <= middle && last >= n - 1 - middle;
  weights_.assign((crosses ? middle : largest) - smallest_ + 1, 0.0);
  for (Size m = 0; m < left.weights.size(); ++m) {
    const Size i = first + m;
    weights_[std::min(i, n - 1 - i) - smallest_] += left.weights[m];
  }
}

StoredSplitRows::StoredSplitRows(const Model& model)
    : rows_(model), keeps_(model.character().row.nanoseconds > read_back_nanoseconds) {}

SplitRow StoredSplitRows::row(Size n) {
  RAMIFY_EXPECTS(n >= 1);
  if (!keeps_) return rows_.row(n);
  while (places_.size() < n) {
    const SplitRow next = rows_.row(places_.size() + 1);
    places_.push_back({next.first, weights_.size()});
    weights_.insert(weights_.end(), next.weights.begin(), next.weights.end());
  }
  const Place& place = places_[n - 1];
  const std::size_t end = n < places_.size() ? places_[n].begin : weights_.size();
  return {n, place.first, std::span(weights_).subspan(place.begin, end - place.begin)};
}

}  // namespace ramify
