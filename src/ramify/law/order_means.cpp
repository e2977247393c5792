#include "ramify/law/order_means.hpp"

#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {

OrderMeans::OrderMeans(Size largest_n) : strahler_(Strahler::recurrence, largest_n) {
  const std::size_t orders = HortonStrahler::largest_order(largest_n) + 1;
  for (auto* counts : {&nodes_, &streams_}) {
    counts->resize(orders);
    for (std::size_t k = 0; k < orders; ++k) {
      (*counts)[k].reserve(largest_n + 1);
      (*counts)[k].append(k == 0 ? 1 : 0);
    }
  }
}

void OrderMeans::extend(const SplitRow& row) {
  strahler_.extend(row);
  // Exact; summed over n levels it would drift by an ulp each.
  nodes_[0].append(static_cast<double>(row.n + 1));
  streams_[0].append(static_cast<double>(row.n + 1));
  for (std::size_t k = 1; k < nodes_.size(); ++k) {
    const auto order = static_cast<std::ptrdiff_t>(k);
    const SizeSeries& below = strahler_.all_sizes(LawForm::at, order - 1);
    nodes_[k].append(over_children(row, nodes_[k]) + strahler_.at(row.n, order));
    streams_[k].append(over_children(row, streams_[k]) + over_children(row, below, below));
  }
}

double OrderMeans::mean(Size n, OrderCount count) const {
  const auto& counts = count.of == OrderCount::Of::nodes ? nodes_ : streams_;
  return count.order < counts.size() ? counts[count.order][n] : 0;
}

std::vector<double> OrderMeans::at_size(const std::vector<SizeSeries>& counts, Size n) {
  std::vector<double> means;
  for (const SizeSeries& count : counts) means.push_back(count[n]);
  return means;
}

}  // namespace ramify
