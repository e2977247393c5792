#include "ramify/tabulate/law_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "ramify/large/large_law.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {
namespace {

constexpr double exact = std::numeric_limits<double>::quiet_NaN();  // an error that is left empty

/// The table of a request: with columns for errors where some of its sizes lie beyond the exact laws.
class LawTable {
 public:
  LawTable(const LawRequest& request, std::vector<std::string> columns,
           const std::vector<std::string>& errors)
      : request_(&request),
        has_errors_(!request.large_sizes().empty()),
        table_(with(std::move(columns), errors)) {}

  Row row(double n) const {
    Row row;
    row.text(request_->model.text());
    return n < 0x1p63 ? row.whole(static_cast<Size>(n)) : row.exact(n);
  }

  void add(Row row, std::initializer_list<double> errors) {
    for (const double error : errors)
      if (has_errors_) row.significant(error, 2);
    table_.add(std::move(row));
  }

  Table finished() { return std::move(table_); }

 private:
  std::vector<std::string> with(std::vector<std::string> columns,
                                const std::vector<std::string>& errors) const {
    if (has_errors_) columns.insert(columns.end(), errors.begin(), errors.end());
    return columns;
  }

  const LawRequest* request_;
  bool has_errors_;
  Table table_;
};

/// One statistic at the sizes of a request, on either side of the seam.
class ValueLaws {
 public:
  ValueLaws(const LawRequest& request, const Cancellation& cancellation)
      : map_(request.subject.statistics.front()->law.map), exact_to_(request.exact_to()) {
    const Recurrence& recurrence = request.subject.statistics.front()->law.recurrence;
    if (const auto sizes = request.exact_sizes(); !sizes.empty()) {
      const Size largest = *std::ranges::max_element(sizes);
      exact_.emplace(build_law(request.model, largest, StatisticLaw(recurrence, largest), cancellation));
    }
    if (const auto sizes = request.large_sizes(); !sizes.empty())
      large_.emplace(request.model, recurrence, sizes, cancellation);
  }

  LargeMoments moments(double n) const {
    if (n > exact_to_) return large_->moments(n).mapped(map_(n));
    const Moments moments = exact_->moments(static_cast<Size>(n)).mapped(map_(n));
    return {{moments.mean, exact}, {moments.variance, exact}};
  }

  LargeFiniteLaw law(double n) const {
    if (n > exact_to_) return large_->law(n)->mapped(map_(n));
    const FiniteLaw law = exact_->law(static_cast<Size>(n))->mapped(map_(n));
    LargeFiniteLaw answer{law.first, {}};
    for (const double p : law.probabilities) answer.probabilities.push_back({p, exact});
    return answer;
  }

 private:
  AffineMap (*map_)(double n);
  double exact_to_;
  std::optional<StatisticLaw> exact_;
  std::optional<LargeLaw> large_;
};

Table value_moments_table(const LawRequest& request, const ValueLaws& laws) {
  LawTable table(request, {"model", "n", "statistic", "mean", "variance"}, {"error", "variance_error"});
  for (const double n : request.sizes) {
    const auto [mean, variance] = laws.moments(n);
    table.add(table.row(n).text(request.subject.name()).exact(mean.value).exact(variance.value),
              {mean.error, variance.error});
  }
  return table.finished();
}

Table value_table(const LawRequest& request, const ValueLaws& laws) {
  LawTable table(request, {"model", "n", "statistic", "value", "probability"}, {"error"});
  for (const double n : request.sizes) {
    const LargeFiniteLaw values = laws.law(n);
    auto value = static_cast<Size>(values.first);
    for (const Approximation& p : values.probabilities) {
      if (p.value > 0)
        table.add(table.row(n).text(request.subject.name()).whole(value).exact(p.value), {p.error});
      ++value;
    }
  }
  return table.finished();
}

/// The counts of all orders at the sizes of a request, on either side of the seam.
class CountLaws {
 public:
  CountLaws(const LawRequest& request, const Cancellation& cancellation)
      : exact_to_(request.exact_to()), cancellation_(&cancellation) {
    if (const auto sizes = request.exact_sizes(); !sizes.empty()) {
      const Size largest = *std::ranges::max_element(sizes);
      means_.emplace(build_law(request.model, largest, OrderMeans(largest), cancellation));
      if (request.quantity != LawQuantity::law)
        moments_.emplace(build_law(request.model, largest, OrderMoments(*means_, largest), cancellation));
    }
    if (const auto sizes = request.large_sizes(); !sizes.empty())
      large_.emplace(request.model, sizes, cancellation);
  }

  Approximation mean(double n, OrderCount count) const {
    if (n <= exact_to_) return {means_->mean(static_cast<Size>(n), count), exact};
    return large_->means(n, count.of).at(count.order);
  }

  Approximation covariance(double n, OrderCount a, OrderCount b) {
    if (n > exact_to_) return large_->covariance(n, a, b, *cancellation_);
    const auto size = static_cast<Size>(n);
    return {a == b ? moments_->variance(size, a) : moments_->covariance(size, a, b), exact};
  }

 private:
  double exact_to_;
  const Cancellation* cancellation_;
  std::optional<OrderMeans> means_;
  std::optional<OrderMoments> moments_;
  std::optional<LargeOrders> large_;
};

std::size_t largest_order(double n) {
  return n < 0x1p63 ? HortonStrahler::largest_order(static_cast<Size>(n))
                    : static_cast<std::size_t>(std::log2(n));
}

Table mean_counts_table(const LawRequest& request, const CountLaws& laws) {
  LawTable table(request, {"model", "n", "leaf_order", "order", "mean_nodes", "mean_streams"}, {"error"});
  for (const double n : request.sizes)
    for (std::size_t k = 0; k <= largest_order(n); ++k) {
      const Approximation nodes = laws.mean(n, {OrderCount::Of::nodes, k}),
                          streams = laws.mean(n, {OrderCount::Of::streams, k});
      table.add(table.row(n).whole(0).whole(k).exact(nodes.value).exact(streams.value),
                {std::fmax(nodes.error, streams.error)});
    }
  return table.finished();
}

/// The counts of the orders that a tree of size n can have: nodes, then streams.
std::vector<StatisticColumn> columns_of(const LawRequest& request, double n) {
  return StatisticSet(request.subject.statistics).columns(largest_order(n));
}

OrderCount count_of(const StatisticColumn& column) {
  return std::get<CountOfOrder>(column.statistic->law.recurrence).at(column.place.high);
}

Table count_moments_table(const LawRequest& request, CountLaws& laws) {
  LawTable table(request, {"model", "n", "statistic", "mean", "variance"}, {"error", "variance_error"});
  for (const double n : request.sizes)
    for (const StatisticColumn& column : columns_of(request, n)) {
      const OrderCount count = count_of(column);
      const Approximation mean = laws.mean(n, count), variance = laws.covariance(n, count, count);
      table.add(table.row(n).text(column.name()).exact(mean.value).exact(variance.value),
                {mean.error, variance.error});
    }
  return table.finished();
}

Table covariance_table(const LawRequest& request, CountLaws& laws) {
  LawTable table(request, {"model", "n", "leaf_order", "first", "second", "covariance"}, {"error"});
  for (const double n : request.sizes) {
    const auto columns = columns_of(request, n);
    for (auto first = columns.begin(); first != columns.end(); ++first)
      for (auto second = first; second != columns.end(); ++second) {
        const Approximation covariance = laws.covariance(n, count_of(*first), count_of(*second));
        table.add(table.row(n).whole(0).text(first->name()).text(second->name()).exact(covariance.value),
                  {covariance.error});
      }
  }
  return table.finished();
}

}  // namespace

Table law_table(const LawRequest& request, const Cancellation& cancellation) {
  const LawWork work = request.work();
  if (!std::holds_alternative<CountOfOrder>(work.recurrence)) {
    const ValueLaws laws(request, cancellation);
    return request.quantity == LawQuantity::moments ? value_moments_table(request, laws)
                                                    : value_table(request, laws);
  }
  CountLaws laws(request, cancellation);
  if (work.means_alone) return mean_counts_table(request, laws);
  return request.quantity == LawQuantity::moments ? count_moments_table(request, laws)
                                                  : covariance_table(request, laws);
}

}  // namespace ramify
