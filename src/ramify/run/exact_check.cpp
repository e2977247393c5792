#include "ramify/run/exact_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

#include "ramify/compare/clumped_count.hpp"
#include "ramify/config/size_grid.hpp"
#include "ramify/run/plan_laws.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

/// The law of a column that counts nodes or streams of an order; null of others.
const CountOfOrder* count_law(const StatisticColumn& column) {
  return std::get_if<CountOfOrder>(&column.statistic->law.recurrence);
}

StatisticColumn streams_of_order(std::size_t order) {
  return {statistic::streams, OrderPlace{order, 0}};
}

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
                        const LawAnswers& laws) {
  constexpr double enough_streams = 100;
  const auto streams = laws.moments(streams_of_order(count.order), n);
  if (!streams || static_cast<double>(column.trees) * streams->mean >= enough_streams) return column.variance;
  const double nodes_of_each =
      count.of == OrderCount::Of::nodes && streams->mean > 0 ? mean / streams->mean : 1;
  return std::max(column.variance, mean * std::max(1.0, 2 * nodes_of_each - 1));
}

/// How far a count lies off; a normal variate only where the trees have enough of it.
double count_z(const OrderCount& count, const ColumnSummary& column, const Moments& exact, Size n,
               const LawAnswers& laws) {
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

std::optional<ExactCheck> check(const ColumnSummary& column, const CellResult& cell, const LawAnswers& laws) {
  const auto exact = laws.moments(column.column, cell.n);
  if (!exact) return std::nullopt;
  if (const CountOfOrder* count = count_law(column.column))
    return ExactCheck{exact->mean,
                      count_z(count->at(column.column.place.high), column, *exact, cell.n, laws)};
  const double variance = std::isnan(exact->variance) ? column.variance : exact->variance;
  return ExactCheck{exact->mean, (column.mean - exact->mean) / standard_error(column, variance)};
}

/// The cells of every model whose trees split, by place in the plan; models by name.
using CellsOfModels = std::map<std::string, std::vector<std::size_t>>;

CellsOfModels cells_of_models(const Plan& plan) {
  CellsOfModels models;
  for (std::size_t c = 0; c < plan.cells.size(); ++c)
    if (plan.cells[c].model.is_split()) models[plan.cells[c].model.text()].push_back(c);
  return models;
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

bool has_curve(const StatisticColumn& column) {
  return column.statistic->shape == Columns::one ||
         (column.statistic->shape == Columns::orders && column.place.high <= highest_drawn_order);
}

/// What is drawn of a model: columns of its largest cell, at many sizes; nothing where all cells have one.
struct Drawn {
  std::vector<StatisticColumn> columns;
  std::vector<Size> sizes;
};

Drawn drawn(const Plan& plan, const std::vector<std::size_t>& cells) {
  const auto [smallest, largest] =
      std::ranges::minmax(cells, {}, [&plan](std::size_t c) { return plan.cells[c].n; });
  if (plan.cells[smallest].n == plan.cells[largest].n) return {};
  Drawn drawn{{}, sizes_between(plan.cells[smallest].n, plan.cells[largest].n)};
  std::ranges::copy_if(columns_of(plan, plan.cells[largest]), std::back_inserter(drawn.columns), has_curve);
  return drawn;
}

/// All that is asked of the laws: beside every column of every cell, and for the curves.
PlanQuestions questions_of(const Plan& plan) {
  PlanQuestions all;
  for (const auto& [model, cells] : cells_of_models(plan)) {
    std::vector<LawQuestion>& questions = all[model];
    for (const std::size_t c : cells)
      for (const StatisticColumn& column : columns_of(plan, plan.cells[c])) {
        questions.push_back({column, plan.cells[c].n});
        if (count_law(column)) questions.push_back({streams_of_order(column.place.high), plan.cells[c].n});
      }
    const auto [columns, sizes] = drawn(plan, cells);
    for (const StatisticColumn& column : columns)
      for (const Size n : sizes) questions.push_back({column, n});
  }
  return all;
}

/// The curves of one model, from its laws.
std::vector<ExactCurve> curves_of(const std::string& model, const Drawn& drawn, const LawAnswers& laws) {
  constexpr Moments unknown{ColumnSummary::none, ColumnSummary::none};
  std::vector<ExactCurve> curves;
  for (const StatisticColumn& column : drawn.columns) {
    ExactCurve curve{model, column, {}};
    for (const Size n : drawn.sizes)
      curve.points.push_back({static_cast<double>(n), laws.moments(column, n).value_or(unknown)});
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

CheckedRun check_against_exact_laws(const Plan& plan, std::vector<FinishedCell> finished,
                                    const Workforce& workforce, const Cancellation& cancellation) {
  const PlanLaws laws = ask_laws(plan, questions_of(plan), workforce, cancellation);
  CheckedRun run{unchecked(std::move(finished))};
  for (CheckedCell& cell : run.cells) {
    const auto of_model = laws.find(cell.result.model);
    if (of_model == laws.end()) continue;
    for (std::size_t c = 0; c < cell.checks.size(); ++c)
      cell.checks[c] = check(cell.result.columns[c], cell.result, of_model->second);
  }
  for (const auto& [model, cells] : cells_of_models(plan))
    std::ranges::move(curves_of(model, drawn(plan, cells), laws.at(model)), std::back_inserter(run.curves));
  return run;
}

void help_check(const Plan& plan, const Workforce& workforce, const Cancellation& cancellation) {
  ask_laws(plan, questions_of(plan), workforce, cancellation);
}

}  // namespace ramify
