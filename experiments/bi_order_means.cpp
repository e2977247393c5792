#include "bi_order_means.hpp"

#include "ramify/statistic/strahler.hpp"

namespace ramify {

BiOrderMeans::BiOrderMeans(std::size_t highest, Size largest_n) : strahler_(Strahler::recurrence, largest_n) {
  for (std::size_t high = 0; high <= highest; ++high)
    for (std::size_t low = 0; low <= high; ++low) joined_[{high, low}].append(0);
}

void BiOrderMeans::extend(const SplitRow& row) {
  const auto has_order = [&](std::size_t k) -> const SizeSeries& {
    return strahler_.all_sizes(LawForm::at, static_cast<std::ptrdiff_t>(k));
  };
  for (auto& [orders, count] : joined_) {
    const auto [high, low] = orders;
    double root = over_children(row, has_order(high), has_order(low));
    if (high != low) root += over_children(row, has_order(low), has_order(high));
    count.append(over_children(row, count) + root);
  }
  strahler_.extend(row);
}

double BiOrderMeans::ramification(Size n, std::size_t k, std::size_t low) const {
  const double begun = joined(n, k - 1, k - 1);
  double nodes = begun;
  for (std::size_t j = 0; j < k; ++j) nodes += joined(n, k, j);
  return (low == k ? begun : joined(n, k, low)) / nodes;
}

}  // namespace ramify
