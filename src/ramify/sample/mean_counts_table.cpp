#include "ramify/sample/mean_counts_table.hpp"

#include <bit>

#include "ramify/large/large_reach.hpp"
#include "ramify/large/order_grid.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/conditional_order_means.hpp"
#include "ramify/law/statistic_law.hpp"

namespace ramify {
namespace {

/// Of a model without large laws: what takes some seconds.
constexpr Size largest_with_exact_means = 8192;

MeanCounts::Tally mean_tally(const ConditionalOrderMeans& law, Size n, std::size_t order) {
  std::vector<double> nodes, streams;
  for (std::size_t k = 1; k <= order; ++k) {
    nodes.push_back(law.mean(n, {OrderCount::Of::nodes, k}, order));
    streams.push_back(law.mean(n, {OrderCount::Of::streams, k}, order));
  }
  return MeanCounts::Tally::of(nodes, streams);
}

}  // namespace

Size MeanCountsTable::largest(const Model& model) {
  return no_large_laws(model).empty() ? MeanCounts::largest_grafted : largest_with_exact_means;
}

MeanCountsTable::MeanCountsTable(const Model& model, Size largest, const Cancellation& cancellation)
    : largest_(largest) {
  const bool all_exact = !no_large_laws(model).empty() || largest <= OrderMeansGrid::exact_to(model);
  append_exact(model, all_exact ? largest : OrderMeansGrid::exact_to(model), cancellation);
  if (!all_exact) append_grid(model, cancellation);
}

void MeanCountsTable::append_exact(const Model& model, Size last, const Cancellation& cancellation) {
  const auto means = build_law(model, last, OrderMeans(last), cancellation);
  const auto given_order = build_law(model, last, ConditionalOrderMeans(means, last), cancellation);
  for (Size n = 0; n <= last; ++n) {
    Table::Law law;
    const FiniteLaw orders = finite_law(means.strahler(), n);
    for (std::size_t i = 0; i < orders.probabilities.size(); ++i) {
      const auto order = static_cast<std::size_t>(orders.first) + i;
      if (orders.probabilities[i] > 0)
        law.push_back({static_cast<MeanCounts::Value>(order), mean_tally(given_order, n, order),
                       orders.probabilities[i]});
    }
    table_.append(std::move(law));
  }
  exact_ = last + 1;
}

void MeanCountsTable::append_grid(const Model& model, const Cancellation& cancellation) {
  const double first = static_cast<double>(exact_) + 1;
  const auto steps =
      static_cast<std::size_t>(std::ceil(std::log((static_cast<double>(largest_) + 1) / first) / step)) + 1;
  const OrderGrid grid(model, first * std::exp(static_cast<double>(steps) * step), cancellation);
  for (std::size_t i = 0; i <= steps; ++i) {
    leaves_.push_back(first * std::exp(static_cast<double>(i) * step));
    Table::Law law;
    for (const OrderOutcome& outcome : grid.orders(leaves_.back()))
      law.push_back({static_cast<MeanCounts::Value>(outcome.order),
                     MeanCounts::Tally::of(outcome.nodes, outcome.streams), outcome.probability});
    table_.append(std::move(law));
  }
}

}  // namespace ramify
