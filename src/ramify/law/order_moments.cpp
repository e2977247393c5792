#include "ramify/law/order_moments.hpp"

#include <algorithm>
#include <limits>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

OrderMoments::OrderMoments(const OrderMeans& means, Size largest_n)
    : means_(&means), top_(HortonStrahler::largest_order(largest_n)), born_(top_ + 1) {
  RAMIFY_EXPECTS(means.sizes() > largest_n);
  const auto nodes = means.nodes(largest_n), streams = means.streams(largest_n);
  counts_.resize(2 * top_);
  second_.resize(2 * top_);
  std::vector<double> external(top_ + 1, 0.0);
  for (std::size_t a = 0; a < counts_.size(); ++a) {
    const double mean = (counts_streams(a) ? streams : nodes)[order_of(a)];
    Count& count = counts_[a];
    count.slope = mean / static_cast<double>(largest_n + 1);
    count.by_order.resize(top_ + 2);
    count.below.resize(top_ + 1);
    count.all.reserve(largest_n + 1);
    for (auto* all_orders : {&count.by_order, &count.below})
      for (SizeSeries& series : *all_orders) series.reserve(largest_n + 1);
    external[0] = -count.slope;
    append(count, external);
    second_[a].resize(a + 1);
    for (std::size_t b = 0; b <= a; ++b) {
      second_[a][b].reserve(largest_n + 1);
      second_[a][b].append(count.slope * counts_[b].slope);
    }
  }
  sizes_ = 1;
}

const SizeSeries& OrderMoments::at(std::size_t order) const {
  return means_->strahler().all_sizes(LawForm::at, static_cast<std::ptrdiff_t>(order));
}

const SizeSeries& OrderMoments::below(std::size_t order) const {
  return means_->strahler().all_sizes(LawForm::below, static_cast<std::ptrdiff_t>(order));
}

void OrderMoments::append(Count& count, const std::vector<double>& by_order) {
  count.by_order[0].append(0);
  double below = 0;
  for (std::size_t s = 0; s < by_order.size(); ++s) {
    count.by_order[s + 1].append(by_order[s]);
    count.below[s].append(below);
    below += by_order[s];
  }
  count.all.append(below);
}

OrderMoments::Joined OrderMoments::joined(const SplitRow& row, const Count& count, std::size_t order) const {
  const SizeSeries &y = count.by_order[order + 1], &y_below = count.below[order];
  const double kept = over_children(row, y, below(order)) + over_children(row, below(order), y) +
                      over_children(row, y_below, at(order)) + over_children(row, at(order), y_below);
  if (order == 0) return {kept, 0};
  const SizeSeries &y_lower = count.by_order[order], &lower = at(order - 1);
  const double born = over_children(row, y_lower, lower) + over_children(row, lower, y_lower);
  return {kept + born, born};
}

/// E[e_a; S = order].
double OrderMoments::added(std::size_t a, std::size_t order, Size n) const {
  if (order_of(a) != order) return 0;
  return counts_streams(a) ? born_[order] : at(order)[n];
}

/// E[e_a (Y_L + Y_R)_b].
double OrderMoments::root_product(std::size_t a, std::size_t b,
                                  const std::vector<std::vector<Joined>>& joined) const {
  const Joined& of_b = joined[b][order_of(a)];
  return counts_streams(a) ? of_b.born : of_b.all;
}

void OrderMoments::extend(const SplitRow& row) {
  RAMIFY_EXPECTS(row.n == sizes_ && row.n < means_->strahler().sizes());
  for (std::size_t s = 1; s <= top_; ++s) born_[s] = over_children(row, at(s - 1), at(s - 1));
  std::vector<std::vector<Joined>> sums(counts_.size());
  for (std::size_t a = 0; a < counts_.size(); ++a)
    for (std::size_t s = 0; s <= top_; ++s) sums[a].push_back(joined(row, counts_[a], s));
  for (std::size_t a = 0; a < counts_.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const SizeSeries &mean_a = counts_[a].all, &mean_b = counts_[b].all;
      double value = over_children(row, second_[a][b]) + over_children(row, mean_a, mean_b) +
                     over_children(row, mean_b, mean_a) + root_product(a, b, sums) + root_product(b, a, sums);
      // e_a e_b = 1 where both count the root: as a node of the order, and, for streams, as one that begins.
      if (order_of(a) == order_of(b)) value += added(a, order_of(a), row.n);  // a counts streams if b does
      second_[a][b].append(value);
    }
  }
  std::vector<double> by_order(top_ + 1);
  for (std::size_t a = 0; a < counts_.size(); ++a) {
    for (std::size_t s = 0; s <= top_; ++s) by_order[s] = sums[a][s].all + added(a, s, row.n);
    append(counts_[a], by_order);
  }
  ++sizes_;
}

std::size_t OrderMoments::index(OrderCount count) const {
  RAMIFY_EXPECTS(count.order >= 1 && count.order <= top_);
  return count.order - 1 + (count.of == OrderCount::Of::streams ? top_ : 0);
}

double OrderMoments::covariance(Size n, OrderCount a, OrderCount b) const {
  if (std::min(a.order, b.order) == 0 || std::max(a.order, b.order) > top_) return 0;
  const std::size_t i = std::max(index(a), index(b)), j = std::min(index(a), index(b));
  return second_[i][j][n] - counts_[i].all[n] * counts_[j].all[n];
}

double OrderMoments::mean_given_order(Size n, OrderCount count, std::size_t order) const {
  const double probability = order <= top_ ? at(order)[n] : 0;
  if (!(probability > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (count.order == 0) return static_cast<double>(n + 1);
  if (count.order > order) return 0;
  const Count& y = counts_[index(count)];
  return y.by_order[order + 1][n] / probability + y.slope * static_cast<double>(n + 1);
}

}  // namespace ramify
