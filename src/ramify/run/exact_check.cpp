#include "ramify/run/exact_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ramify/core/parallel.hpp"
#include "ramify/large/finite_means.hpp"

namespace ramify {
namespace {

/// A sample of T trees cannot tell an event of probability below 1/T from none, so no error is taken below
/// 1/T.
double standard_error(const ColumnSummary& column, const Moments& exact) {
  const double count = static_cast<double>(column.trees);
  const double variance = std::isnan(exact.variance) ? column.variance : exact.variance;
  return std::max(std::sqrt(variance / count), 1 / count);
}

std::optional<ExactCheck> check(const ColumnSummary& column, const CellResult& cell,
                                const FiniteMeans& laws) {
  const auto exact = laws.moments(column.column, cell.n);
  if (!exact) return std::nullopt;
  return ExactCheck{exact->mean, (column.mean - exact->mean) / standard_error(column, *exact)};
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

std::vector<CheckedCell> check_against_exact_laws(const Plan& plan, std::vector<FinishedCell> cells,
                                                  unsigned threads) {
  std::vector<CheckedCell> checked = unchecked(std::move(cells));
  std::map<std::string, std::vector<std::size_t>> by_model;
  for (std::size_t i = 0; i < checked.size(); ++i) by_model[checked[i].result.model].push_back(i);
  const std::vector<std::pair<std::string, std::vector<std::size_t>>> groups(by_model.begin(),
                                                                             by_model.end());
  parallel_for(groups.size(), threads, [&](std::size_t group, unsigned) {
    const auto& members = groups[group].second;
    const Model& model = plan.cells[checked[members.front()].number - 1].model;
    if (!model.is_split()) return;
    std::vector<Size> sizes;
    for (const std::size_t i : members) sizes.push_back(checked[i].result.n);
    const FiniteMeans laws(model, sizes);
    for (const std::size_t i : members)
      for (std::size_t c = 0; c < checked[i].checks.size(); ++c)
        checked[i].checks[c] = check(checked[i].result.columns[c], checked[i].result, laws);
  });
  return checked;
}

}  // namespace ramify
