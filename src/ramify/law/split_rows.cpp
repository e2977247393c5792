#include "ramify/law/split_rows.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/law/trim.hpp"
#include "ramify/model/binomial_weights.hpp"

namespace ramify {
namespace {

constexpr double negligible = 1e-18;
constexpr double far_below = 1e-40;  // of the mode of a binomial law: P(K = 0) may be nearly all of it

}  // namespace

SplitRows::SplitRows(const Model& model) : law_(model.law()) {
  if (const auto* beta = std::get_if<Beta>(&law_)) beta_.emplace(*beta);
}

SplitRow SplitRows::row(Size n) {
  RAMIFY_EXPECTS(n >= 1);
  if (n == 1) {
    take({0, {1.0}});
  } else {
    std::visit([this, n](const auto& law) { fill(law, n); }, law_);
  }
  fold(n);
  const auto kept = trim_to_law(weights_, negligible);
  return {n, smallest_ + static_cast<Size>(kept.data() - weights_.data()), kept};
}

void SplitRows::take(WeightWindow window) {
  first_ = window.first;
  left_ = std::move(window.weights);
}

void SplitRows::fill(const Bst&, Size n) {
  take({0, std::vector<double>(n, 1 / static_cast<double>(n))});
}

void SplitRows::fill(const Beta&, Size n) {
  first_ = 0;
  beta_->fill(n, left_);
}

void SplitRows::fill(const BetaMultinomial& law, Size n) {
  take(law.window(n, far_below));
}

void SplitRows::fill(const FixedSplit& law, Size n) {
  take({law.left(n), {1.0}});
}

void SplitRows::fill(const Dst& law, Size n) {
  take(binomial_window(n - 1, law.p(), far_below));
}

void SplitRows::fill(const Patricia& law, Size n) {
  take(law.window(n, far_below));
}

void SplitRows::fill(const Catalan&, Size n) {
  for (Size i = catalan_.size(); i < n; ++i)
    catalan_.push_back(Catalan::central_binomial(i) / static_cast<double>(i + 1));
  first_ = 0;
  left_.resize(n);
  for (Size i = 0; i < n; ++i) left_[i] = catalan_[i] * catalan_[n - 1 - i];
}

void SplitRows::fill(const Aldous& law, Size n) {
  take(law.window(n, far_below));
}

void SplitRows::fill(const Complete& law, Size n) {
  take({law.left(n), {1.0}});
}

/// One side is as good as the other here.
void SplitRows::fill(const Chain&, Size) {
  take({0, {1.0}});
}

void SplitRows::fill(const TabulatedSplit& law, Size n) {
  take({0, law.pmf(n)});
}

/// Puts i and n-1-i together.
void SplitRows::fold(Size n) {
  const Size last = first_ + left_.size() - 1;
  smallest_ = std::min(first_, n - 1 - last);
  const Size largest = std::max(std::min(first_, n - 1 - first_), std::min(last, n - 1 - last));
  const Size middle = (n - 1) / 2;
  const bool crosses = first_ <= middle && last >= n - 1 - middle;
  weights_.assign((crosses ? middle : largest) - smallest_ + 1, 0.0);
  for (Size m = 0; m < left_.size(); ++m) {
    const Size i = first_ + m;
    weights_[std::min(i, n - 1 - i) - smallest_] += left_[m];
  }
}

StoredSplitRows::StoredSplitRows(const Model& model)
    : rows_(model),
      keeps_(!std::holds_alternative<Bst>(model.law()) && !std::holds_alternative<Catalan>(model.law())) {}

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
