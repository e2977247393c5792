#include "ramify/run/exact_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string_view>

#include "ramify/compare/clumped_count.hpp"
#include "ramify/config/size_grid.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/large/finite_means.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

/// A sample of T trees cannot tell an event of probability below 1/T from none, so no error is taken below
/// 1/T.
double standard_error(const ColumnSummary& column, double variance) {
  const double count = static_cast<double>(column.trees);
  return std::max(std::sqrt(variance / count), 1 / count);
}

/// The variance of a count of which only the mean is known: that of the sample; where the sample has few
/// streams of the order that of streams with geometric numbers of nodes, if it is larger. A sample that has
/// none does not know it.
double unknown_variance(const OrderCount& count, const ColumnSummary& column, double mean, Size n,
                        const FiniteMeans& laws) {
  constexpr double enough_streams = 100;
  const auto streams = laws.moments({statistic::streams, OrderPlace{count.order, 0}}, n);
  if (!streams || static_cast<double>(column.trees) * streams->mean >= enough_streams) return column.variance;
  const double nodes_of_each =
      count.of == OrderCount::Of::nodes && streams->mean > 0 ? mean / streams->mean : 1;
  return std::max(column.variance, mean * std::max(1.0, 2 * nodes_of_each - 1));
}

/// How far a count lies off; a normal variate only where the trees have enough of it.
double count_z(const OrderCount& count, const ColumnSummary& column, const Moments& exact, Size n,
               const FiniteMeans& laws) {
  const double trees = static_cast<double>(column.trees), mean = trees * exact.mean;
  const bool known = !std::isnan(exact.variance);
  // A whole number that is there with chance m has the variance m(1-m) at least, whatever rounding leaves.
  const double variance =
      trees * std::max(exact.mean * (1 - exact.mean),
                       known ? exact.variance : unknown_variance(count, column, exact.mean, n, laws));
  if (mean * mean <= largest_clump_ratio * variance)
    return clumped_count_z(std::round(trees * column.mean), mean, variance);
  return (column.mean - exact.mean) / standard_error(column, known ? exact.variance : column.variance);
}

std::optional<ExactCheck> check(const ColumnSummary& column, const CellResult& cell,
                                const FiniteMeans& laws) {
  const auto exact = laws.moments(column.column, cell.n);
  if (!exact) return std::nullopt;
  if (const auto* count = std::get_if<CountOfOrder>(&column.column.statistic->law.recurrence))
    return ExactCheck{exact->mean,
                      count_z(count->at(column.column.place.high), column, *exact, cell.n, laws)};
  const double variance = std::isnan(exact->variance) ? column.variance : exact->variance;
  return ExactCheck{exact->mean, (column.mean - exact->mean) / standard_error(column, variance)};
}

/// The cells of every model, models by name.
std::vector<std::vector<CheckedCell*>> models_of(std::vector<CheckedCell>& cells) {
  std::map<std::string_view, std::vector<CheckedCell*>> by_model;
  for (CheckedCell& cell : cells) by_model[cell.result.model].push_back(&cell);
  std::vector<std::vector<CheckedCell*>> groups;
  for (auto& [model, members] : by_model) groups.push_back(std::move(members));
  return groups;
}

/// Sizes between the smallest and the largest, in equal steps of log n: enough for an oscillation that comes
/// again with every factor of 2.
std::vector<Size> sizes_between(Size smallest, Size largest) {
  constexpr double steps = 48;  // per factor of 10
  const Size from = std::max<Size>(1, smallest);
  if (largest <= from) return {from};
  const double decades = std::log10(static_cast<double>(largest) / static_cast<double>(from));
  return geometric_grid(from, largest, static_cast<std::size_t>(std::ceil(steps * decades)) + 1);
}

bool is_drawn(const StatisticColumn& column) {
  return column.statistic->shape == Columns::one ||
         (column.statistic->shape == Columns::orders && column.place.high <= highest_drawn_order);
}

/// The curves of one model, from its laws; none where all of its cells have one size.
std::vector<ExactCurve> curves_of(const std::vector<CheckedCell*>& cells, const FiniteMeans& laws) {
  const auto [smallest, largest] =
      std::ranges::minmax_element(cells, {}, [](const CheckedCell* cell) { return cell->result.n; });
  constexpr Moments unknown{ColumnSummary::none, ColumnSummary::none};
  std::vector<ExactCurve> curves;
  if ((*smallest)->result.n == (*largest)->result.n) return curves;
  const auto sizes = sizes_between((*smallest)->result.n, (*largest)->result.n);
  for (const ColumnSummary& summary : (*largest)->result.columns) {
    if (!is_drawn(summary.column)) continue;
    ExactCurve curve{(*largest)->result.model, summary.column, {}};
    for (const Size n : sizes)
      curve.points.push_back({static_cast<double>(n), laws.moments(curve.column, n).value_or(unknown)});
    const auto is_known = [](const ExactCurve::Point& point) { return !std::isnan(point.moments.mean); };
    if (std::ranges::any_of(curve.points, is_known)) curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

std::vector<CheckedCell> unchecked(std::vector<FinishedCell> cells) {
  std::vector<CheckedCell> result;
  for (auto& cell : cells) {
    result.push_back({cell.index + 1, std::move(cell.result), {}});
    result.back().checks.resize(result.back().result.columns.size());
  }
  return result;
}

CheckedRun check_against_exact_laws(const Plan& plan, std::vector<FinishedCell> finished, unsigned threads,
                                    const Cancellation& cancellation) {
  CheckedRun run{unchecked(std::move(finished))};
  const auto groups = models_of(run.cells);
  std::vector<std::vector<ExactCurve>> curves(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t group, unsigned) {
    const auto& members = groups[group];
    const Model& model = plan.cells[members.front()->number - 1].model;
    if (!model.is_split()) return;
    std::vector<Size> sizes;
    for (const CheckedCell* cell : members) sizes.push_back(cell->result.n);
    const FiniteMeans laws(model, sizes);
    for (CheckedCell* cell : members)
      for (std::size_t c = 0; c < cell->checks.size(); ++c) {
        if (cancellation.requested()) throw Interrupted();
        cell->checks[c] = check(cell->result.columns[c], cell->result, laws);
      }
    curves[group] = curves_of(members, laws);
  });
  for (auto& of_model : curves) std::ranges::move(of_model, std::back_inserter(run.curves));
  return run;
}

}  // namespace ramify
