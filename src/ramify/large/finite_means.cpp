#include "ramify/large/finite_means.hpp"

#include <algorithm>
#include <limits>

#include "ramify/large/large_reach.hpp"
#include "ramify/law/law_cost.hpp"
#include "ramify/law/law_limit.hpp"

namespace ramify {
namespace {

/// The largest size that has an exact law.
Size largest_given(const Model& model, const std::vector<Size>& sizes) {
  Size largest = 0;
  for (const Size n : sizes)
    if (n <= law_limit(model)) largest = std::max(largest, n);
  return largest;
}

/// The same; where others lie beyond, as far as the grid at least, which goes
/// on from there: sizes between the given ones are asked for too.
Size largest_exact(const Model& model, const std::vector<Size>& sizes) {
  const Size given = largest_given(model, sizes), limit = law_limit(model);
  const bool others_lie_beyond = std::ranges::any_of(sizes, [limit](Size n) { return n > limit; });
  return others_lie_beyond ? std::max(given, std::min(limit, large_law_table(model))) : given;
}

std::vector<double> beyond(const Model& model, const std::vector<Size>& sizes) {
  std::vector<double> large;
  for (const Size n : sizes)
    if (n > std::max(law_limit(model), large_law_table(model))) large.push_back(static_cast<double>(n));
  std::ranges::sort(large);
  return no_large_laws(model).empty() ? large : std::vector<double>();
}

double exact_seconds(const Model& model, const Recurrence& recurrence, Size n) {
  const bool counts = std::holds_alternative<CountOfOrder>(recurrence);
  return law_cost(model, {recurrence, counts && n > order_moments_limit(model)}, n).seconds;
}

bool takes_too_long(const Model& model, const Recurrence& recurrence, double n) {
  return large_law_seconds(model, recurrence, n) > FiniteMeans::longest_seconds;
}

/// What is computed once for many columns: the counts of all orders are.
Recurrence shared(const Recurrence& recurrence) {
  if (std::holds_alternative<CountOfOrder>(recurrence)) return CountOfOrder{OrderCount::Of::nodes};
  return recurrence;
}

}  // namespace

FiniteMeansCost FiniteMeans::cost(const Model& model, const std::vector<Size>& sizes,
                                  const StatisticSet& statistics) {
  FiniteMeansCost cost{0, {}};
  const Size exact = largest_exact(model, sizes);
  const std::vector<double> large = beyond(model, sizes);
  std::vector<Recurrence> counted;
  for (const StatisticInfo* statistic : statistics.chosen()) {
    const Recurrence recurrence = shared(statistic->law.recurrence);
    if (known_of(recurrence) <= Known::value) continue;
    const bool is_left_out = !large.empty() && takes_too_long(model, recurrence, large.back());
    if (is_left_out) cost.left_out.push_back(statistic->name);
    if (std::ranges::find(counted, recurrence) != counted.end()) continue;
    counted.push_back(recurrence);
    if (exact > 0) cost.seconds += exact_seconds(model, recurrence, exact);
    if (!large.empty() && !is_left_out) cost.seconds += large_law_seconds(model, recurrence, large.back());
  }
  return cost;
}

FiniteMeans::FiniteMeans(const Model& model, const std::vector<Size>& sizes)
    : model_(model),
      large_sizes_(beyond(model, sizes)),
      exact_(model, largest_exact(model, sizes), largest_given(model, sizes)) {}

std::optional<Moments> FiniteMeans::moments(const StatisticColumn& column, Size n) const {
  if (n <= exact_.largest_n()) return exact_.moments(column, n);
  if (large_sizes_.empty() || n < large_law_table(model_) || static_cast<double>(n) > large_sizes_.back())
    return std::nullopt;
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
  if (known_of(recurrence) == Known::nothing || takes_too_long(model_, recurrence, large_sizes_.back()))
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
