#include "ramify/law/conditional_order_means.hpp"

#include <algorithm>
#include <limits>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

ConditionalOrderMeans::ConditionalOrderMeans(const OrderMeans& means, Size largest_n)
    : means_(&means), top_(HortonStrahler::largest_order(largest_n)) {
  RAMIFY_EXPECTS(means.sizes() > largest_n);
  const auto nodes = means.nodes(largest_n), streams = means.streams(largest_n);
  counts_.resize(2 * top_);
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
  }
  sizes_ = 1;
}

const SizeSeries& ConditionalOrderMeans::at(std::size_t order) const {
  return means_->strahler().all_sizes(LawForm::at, static_cast<std::ptrdiff_t>(order));
}

const SizeSeries& ConditionalOrderMeans::below(std::size_t order) const {
  return means_->strahler().all_sizes(LawForm::below, static_cast<std::ptrdiff_t>(order));
}

void ConditionalOrderMeans::append(Count& count, const std::vector<double>& by_order) {
  count.by_order[0].append(0);
  double below = 0;
  for (std::size_t s = 0; s < by_order.size(); ++s) {
    count.by_order[s + 1].append(by_order[s]);
    count.below[s].append(below);
    below += by_order[s];
  }
  count.all.append(below);
}

ConditionalOrderMeans::Joined ConditionalOrderMeans::joined(const SplitRow& row, std::size_t a,
                                                            std::size_t order, double born) const {
  const Count& count = counts_[a];
  if (order < order_of(a)) {  // X = 0
    const double centre = -count.slope * static_cast<double>(row.n + 1);
    return {centre * at(order)[row.n], centre * born};
  }
  const SizeSeries &y = count.by_order[order + 1], &y_below = count.below[order];
  const double kept = over_children(row, y, below(order)) + over_children(row, below(order), y) +
                      over_children(row, y_below, at(order)) + over_children(row, at(order), y_below);
  const SizeSeries &y_lower = count.by_order[order], &lower = at(order - 1);
  const double joined_lower = over_children(row, y_lower, lower) + over_children(row, lower, y_lower);
  return {kept + joined_lower, joined_lower};
}

ConditionalOrderMeans::Step ConditionalOrderMeans::step(const SplitRow& row) const {
  RAMIFY_EXPECTS(row.n == sizes_ && row.n < means_->strahler().sizes());
  Step step{row.n, std::vector<std::vector<Joined>>(counts_.size()), std::vector<double>(top_ + 1)};
  for (std::size_t s = 1; s <= top_; ++s) step.born[s] = over_children(row, at(s - 1), at(s - 1));
  for (std::size_t a = 0; a < counts_.size(); ++a)
    for (std::size_t s = 0; s <= top_; ++s) step.joined[a].push_back(joined(row, a, s, step.born[s]));
  return step;
}

double ConditionalOrderMeans::added(std::size_t a, std::size_t order, const Step& step) const {
  if (order_of(a) != order) return 0;
  return counts_streams(a) ? step.born[order] : at(order)[step.n];
}

void ConditionalOrderMeans::append(const Step& step) {
  std::vector<double> by_order(top_ + 1);
  for (std::size_t a = 0; a < counts_.size(); ++a) {
    for (std::size_t s = 0; s <= top_; ++s) by_order[s] = step.joined[a][s].all + added(a, s, step);
    append(counts_[a], by_order);
  }
  ++sizes_;
}

std::size_t ConditionalOrderMeans::index(OrderCount count) const {
  RAMIFY_EXPECTS(count.order >= 1 && count.order <= top_);
  return count.order - 1 + (count.of == OrderCount::Of::streams ? top_ : 0);
}

double ConditionalOrderMeans::mean(Size n, OrderCount count, std::size_t order) const {
  const double probability = order <= top_ ? at(order)[n] : 0;
  if (!(probability > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (count.order == 0) return static_cast<double>(n + 1);
  if (count.order > order) return 0;
  const Count& y = counts_[index(count)];
  return y.by_order[order + 1][n] / probability + y.slope * static_cast<double>(n + 1);
}

double ConditionalOrderMeans::about_mean(Size n, OrderCount count, std::size_t order) const {
  if (count.order == 0 || std::max(count.order, order) > top_) return 0;
  const Count& y = counts_[index(count)];
  return y.by_order[order + 1][n] - y.all[n] * at(order)[n];
}

}  // namespace ramify
