#include "ramify/large/finite_means.hpp"

#include <algorithm>
#include <limits>

#include "ramify/law/law_limit.hpp"

namespace ramify {
namespace {

Size largest_exact(const Model& model, const std::vector<Size>& sizes) {
  Size largest = 0;
  for (const Size n : sizes)
    if (n <= law_limit(model)) largest = std::max(largest, n);
  return largest;
}

std::vector<double> beyond(const Model& model, const std::vector<Size>& sizes) {
  std::vector<double> large;
  for (const Size n : sizes)
    if (n > std::max(law_limit(model), large_law_table(model))) large.push_back(static_cast<double>(n));
  std::ranges::sort(large);
  return no_large_laws(model).empty() ? large : std::vector<double>();
}

}  // namespace

FiniteMeans::FiniteMeans(const Model& model, const std::vector<Size>& sizes)
    : model_(model), large_sizes_(beyond(model, sizes)), exact_(model, largest_exact(model, sizes)) {}

std::optional<Moments> FiniteMeans::moments(const StatisticColumn& column, Size n) const {
  if (n <= exact_.largest_n()) return exact_.moments(column, n);
  if (!std::ranges::binary_search(large_sizes_, static_cast<double>(n))) return std::nullopt;
  const ExactLaw& law = column.statistic->law;
  const auto moments = large_moments(law.recurrence, column.place, n);
  return moments ? std::optional(moments->mapped(law.map(static_cast<double>(n)))) : std::nullopt;
}

std::optional<Moments> FiniteMeans::large_moments(const Recurrence& recurrence, const OrderPlace& place,
                                                  Size n) const {
  const auto size = static_cast<double>(n);
  if (const auto* known = std::get_if<KnownBySize>(&recurrence))
    return Moments{static_cast<double>(n + known->more), 0};
  if (const auto* count = std::get_if<CountOfOrder>(&recurrence))
    return of_count(count->at(place.high), size);
  if (known_of(recurrence) == Known::nothing ||
      large_law_seconds(model_, recurrence, large_sizes_.back()) > longest_seconds)
    return std::nullopt;
  auto found =
      std::ranges::find(laws_, recurrence, [](const auto& kept) -> const Recurrence& { return kept.first; });
  if (found == laws_.end())
    found = laws_.emplace(laws_.end(), recurrence, LargeLaw(model_, recurrence, large_sizes_));
  const LargeMoments moments = found->second.moments(size);
  return Moments{moments.mean.value, moments.variance.value};
}

Moments FiniteMeans::of_count(OrderCount count, double n) const {
  if (!orders_) orders_.emplace(model_, large_sizes_);
  const auto means = orders_->means(n, count.of);
  const double mean = count.order < means.size() ? means[count.order].value : 0;
  return {mean, std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace ramify
