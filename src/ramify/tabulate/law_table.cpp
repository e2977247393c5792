#include "ramify/tabulate/law_table.hpp"

#include "ramify/law/build_law.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/law/statistic_law.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {
namespace {

Row row_of(const LawRequest& request, Size n) {
  Row row;
  row.text(request.model.text()).whole(n);
  return row;
}

Table moments_table() {
  return Table({"model", "n", "statistic", "mean", "variance"});
}

Table value_table(const LawRequest& request, const StatisticLaw& law) {
  const StatisticInfo& statistic = *request.subject.statistics.front();
  if (request.quantity == LawQuantity::moments) {
    Table table = moments_table();
    for (const Size n : request.sizes) {
      const auto [mean, variance] = law.moments(n).mapped(statistic.law.map(n));
      table.add(row_of(request, n).text(statistic.name).exact(mean).exact(variance));
    }
    return table;
  }
  Table table({"model", "n", "statistic", "value", "probability"});
  for (const Size n : request.sizes) {
    const FiniteLaw values = law.law(n)->mapped(statistic.law.map(n));
    auto value = static_cast<Size>(values.first);
    for (const double probability : values.probabilities) {
      if (probability > 0) table.add(row_of(request, n).text(statistic.name).whole(value).exact(probability));
      ++value;
    }
  }
  return table;
}

Table mean_counts_table(const LawRequest& request, const OrderMeans& law) {
  Table table({"model", "n", "leaf_order", "order", "mean_nodes", "mean_streams"});
  for (const Size n : request.sizes) {
    const auto nodes = law.nodes(n), streams = law.streams(n);
    for (std::size_t k = 0; k <= HortonStrahler::largest_order(n); ++k)
      table.add(row_of(request, n).whole(0).whole(k).exact(nodes[k]).exact(streams[k]));
  }
  return table;
}

/// The counts of the orders that a tree of size n can have: nodes, then streams.
std::vector<StatisticColumn> columns_of(const LawRequest& request, Size n) {
  return StatisticSet(request.subject.statistics).columns(HortonStrahler::largest_order(n));
}

OrderCount count_of(const StatisticColumn& column) {
  return std::get<CountOfOrder>(column.statistic->law.recurrence).at(column.place.high);
}

Table count_moments_table(const LawRequest& request, const OrderMoments& law) {
  Table table = moments_table();
  for (const Size n : request.sizes)
    for (const StatisticColumn& column : columns_of(request, n)) {
      const OrderCount count = count_of(column);
      table.add(
          row_of(request, n).text(column.name()).exact(law.mean(n, count)).exact(law.variance(n, count)));
    }
  return table;
}

Table covariance_table(const LawRequest& request, const OrderMoments& law) {
  Table table({"model", "n", "leaf_order", "first", "second", "covariance"});
  for (const Size n : request.sizes) {
    const auto columns = columns_of(request, n);
    for (auto first = columns.begin(); first != columns.end(); ++first)
      for (auto second = first; second != columns.end(); ++second)
        table.add(row_of(request, n)
                      .whole(0)
                      .text(first->name())
                      .text(second->name())
                      .exact(law.covariance(n, count_of(*first), count_of(*second))));
  }
  return table;
}

}  // namespace

Table law_table(const LawRequest& request, const Cancellation& cancellation) {
  const LawWork work = request.work();
  const Size largest = request.largest_size();
  const auto build = [&](auto law) {
    return build_law(request.model, largest, std::move(law), cancellation);
  };
  if (!std::holds_alternative<CountOfOrder>(work.recurrence))
    return value_table(request, build(StatisticLaw(work.recurrence, largest)));
  const OrderMeans means = build(OrderMeans(largest));
  if (work.means_alone) return mean_counts_table(request, means);
  const OrderMoments moments = build(OrderMoments(means, largest));
  return request.quantity == LawQuantity::moments ? count_moments_table(request, moments)
                                                  : covariance_table(request, moments);
}

}  // namespace ramify
