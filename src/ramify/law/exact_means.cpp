#include "ramify/law/exact_means.hpp"

#include <algorithm>
#include <limits>

#include "ramify/law/build_law.hpp"
#include "ramify/law/law_limit.hpp"

namespace ramify {

ExactMeans::ExactMeans(const Model& model, Size largest_n, Size largest_n_with_variances)
    : largest_n_(std::min(largest_n, law_limit(model))),
      largest_n_with_variances_(std::min({largest_n, largest_n_with_variances, order_moments_limit(model)})),
      rows_(model) {}

/// The law with every size up to n.
template <class Law>
const Law& ExactMeans::extended(Law& law, Size n) const {
  extend_law(law, rows_, n);
  return law;
}

const StatisticLaw& ExactMeans::computed(const Recurrence& recurrence, Size n) const {
  auto found =
      std::ranges::find(laws_, recurrence, [](const auto& kept) -> const Recurrence& { return kept.first; });
  if (found == laws_.end())
    found = laws_.emplace(laws_.end(), recurrence, StatisticLaw(recurrence, largest_n_));
  return extended(found->second, n);
}

Moments ExactMeans::of_count(Size n, OrderCount count) const {
  if (!orders_) orders_.emplace(largest_n_);
  const double mean = extended(*orders_, n).mean(n, count);
  if (n > largest_n_with_variances_) return {mean, std::numeric_limits<double>::quiet_NaN()};
  if (!order_moments_)
    order_moments_.emplace(extended(*orders_, largest_n_with_variances_), largest_n_with_variances_);
  return {mean, extended(*order_moments_, n).variance(n, count)};
}

Moments ExactMeans::of_recurrence(const StatisticColumn& column, Size n) const {
  const Recurrence& recurrence = column.statistic->law.recurrence;
  if (const auto* known = std::get_if<KnownBySize>(&recurrence))
    return {static_cast<double>(n + known->more), 0};
  if (const auto* count = std::get_if<CountOfOrder>(&recurrence))
    return of_count(n, count->at(column.place.high));
  return computed(recurrence, n).moments(n);
}

std::optional<Moments> ExactMeans::moments(const StatisticColumn& column, Size n) const {
  const ExactLaw& law = column.statistic->law;
  if (n > largest_n_ || known_of(law.recurrence) == Known::nothing) return std::nullopt;
  return of_recurrence(column, n).mapped(law.map(static_cast<double>(n)));
}

std::optional<FiniteLaw> ExactMeans::law(const StatisticColumn& column, Size n) const {
  const ExactLaw& law = column.statistic->law;
  if (n > largest_n_ || known_of(law.recurrence) != Known::law) return std::nullopt;
  return computed(law.recurrence, n).law(n)->mapped(law.map(static_cast<double>(n)));
}

}  // namespace ramify
