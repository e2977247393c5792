#include "ramify/law/split_rows.hpp"

#include <algorithm>
#include <numeric>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

constexpr double negligible = 1e-18;

}  // namespace

SplitRow SplitRows::row(Size n) {
  RAMIFY_EXPECTS(n >= 1);
  weights_.assign(1, 1.0);
  if (n == 1) return {1, 0, weights_};
  weights_ = std::visit([n](const auto& law) { return law.pmf(n); }, law_);
  const std::size_t half = (n + 1) / 2;
  for (std::size_t i = half; i < n; ++i) weights_[n - 1 - i] += weights_[i];
  const auto kept = [](double w) { return w >= negligible; };
  const auto begin =
      std::find_if(weights_.begin(), weights_.begin() + static_cast<std::ptrdiff_t>(half), kept);
  auto end = weights_.begin() + static_cast<std::ptrdiff_t>(half);
  while (end > begin && !kept(end[-1])) --end;
  const double sum = std::accumulate(begin, end, 0.0);
  std::for_each(begin, end, [sum](double& w) { w /= sum; });
  return {n, static_cast<Size>(begin - weights_.begin()), {begin, end}};
}

SplitRow StoredSplitRows::row(Size n) {
  RAMIFY_EXPECTS(n >= 1);
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
