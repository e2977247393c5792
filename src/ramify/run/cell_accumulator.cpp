#include "ramify/run/cell_accumulator.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

constexpr Estimate no_estimate{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()};

template <class Summary>
ColumnSummary moments_of(const StatisticColumn& column, const Summary& values) {
  ColumnSummary summary{column};
  summary.trees = values.count();
  summary.mean = values.mean();
  summary.variance = values.variance();
  summary.standard_error = std::sqrt(summary.variance / static_cast<double>(values.count()));
  return summary;
}

ColumnSummary summarise(const StatisticColumn& column, const WholeSummary& values) {
  if (values.count() == 0) return ColumnSummary{column};
  ColumnSummary summary = moments_of(column, values);
  summary.min = static_cast<double>(values.min());
  summary.q05 = static_cast<double>(values.quantile(0.05));
  summary.q50 = static_cast<double>(values.quantile(0.5));
  summary.q95 = static_cast<double>(values.quantile(0.95));
  summary.max = static_cast<double>(values.max());
  if (values.occurrences().size() <= ColumnSummary::histogram_values)
    summary.histogram.assign(values.occurrences().begin(), values.occurrences().end());
  return summary;
}

ColumnSummary summarise(const StatisticColumn& column, const RealSummary& values) {
  ColumnSummary summary = moments_of(column, values);
  if (values.count() == 0) return summary;
  const auto quantiles = values.quantiles({1e-300, 0.05, 0.5, 0.95, 1});
  summary.min = quantiles[0];
  summary.q05 = quantiles[1];
  summary.q50 = quantiles[2];
  summary.q95 = quantiles[3];
  summary.max = quantiles[4];
  return summary;
}

}  // namespace

void CellSums::merge(const CellSums& later) {
  for (std::size_t i = 0; i < wholes.size(); ++i) wholes[i].merge(later.wholes[i]);
  for (std::size_t i = 0; i < reals.size(); ++i) reals[i].merge(later.reals[i]);
  nodes.merge(later.nodes);
  streams.merge(later.streams);
}

const ColumnSummary& CellResult::column(const StatisticColumn& column) const {
  for (const auto& summary : columns)
    if (summary.column == column) return summary;
  throw std::out_of_range("no column " + column.name());
}

CellAccumulator::CellAccumulator(const StatisticSet& statistics, std::size_t largest_order)
    : columns_(statistics.columns(largest_order)),
      counts_orders_(statistics.contains(statistic::nodes) || statistics.contains(statistic::streams)) {
  std::size_t wholes = 0, reals = 0;
  for (const auto& column : columns_) slot_.push_back(column.statistic->real ? reals++ : wholes++);
  sums_.wholes.resize(wholes);
  sums_.reals.resize(reals);
}

void CellAccumulator::add(const TreeMeasures& measures) {
  write_statistics(columns_, measures, row_);
  for (std::size_t i = 0; i < row_.size(); ++i) {
    if (columns_[i].statistic->real)
      sums_.reals[slot_[i]].add(row_[i].real);
    else if (columns_[i].has(row_[i]))
      sums_.wholes[slot_[i]].add(row_[i].whole);
  }
  if (!counts_orders_) return;
  sums_.nodes.add(measures.nodes, measures.strahler);
  sums_.streams.add(measures.streams, measures.strahler);
}

std::vector<ColumnSummary> CellAccumulator::summarise() const {
  std::vector<ColumnSummary> columns;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    columns.push_back(columns_[i].statistic->real ? ramify::summarise(columns_[i], sums_.reals[slot_[i]])
                                                  : ramify::summarise(columns_[i], sums_.wholes[slot_[i]]));
  return columns;
}

std::vector<OrderSummary> CellAccumulator::summarise_orders() const {
  std::vector<OrderSummary> orders;
  for (std::size_t k = 0; k <= sums_.nodes.highest(); ++k) {
    const bool top = k == sums_.nodes.highest();
    orders.push_back({sums_.nodes.mean(k), sums_.streams.mean(k),
                      top ? no_estimate : sums_.nodes.pooled_ratio(k),
                      top ? no_estimate : sums_.streams.pooled_ratio(k)});
  }
  return orders;
}

CellResult CellAccumulator::result(const Cell& cell) const {
  return {cell.model.text(), cell.n, cell.replicates, summarise(),
          counts_orders_ ? summarise_orders() : std::vector<OrderSummary>()};
}

}  // namespace ramify
