#include "evidence.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "ramify/run/plan.hpp"

namespace ramify {
namespace {

ModelCells& cells_of(std::vector<ModelCells>& models, const Model& model) {
  auto place = std::ranges::find(models, model, &ModelCells::model);
  if (place == models.end()) place = models.insert(models.end(), ModelCells{model, {}});
  return *place;
}

}  // namespace

void Evidence::add(const RunConfig& config, const CheckedRun& run) {
  const Plan plan = make_plan(config);
  looks_.add(config);
  for (const Claim* claim : served_claims(config)) {
    auto& models = models_[claim->id];
    for (const auto& cell : run.cells)
      cells_of(models, plan.cells[cell.number - 1].model).cells.push_back(cell);
    for (auto& model : models) {
      model.look = looks_.of(model.model.text());
      std::ranges::stable_sort(model.cells, {}, [](const CheckedCell& cell) { return cell.result.n; });
      std::ranges::copy_if(run.curves, std::back_inserter(model.curves),
                           [&](const ExactCurve& curve) { return curve.model == model.model.text(); });
    }
  }
  all_.insert(all_.end(), run.cells.begin(), run.cells.end());
}

std::vector<Verdict> Evidence::verdicts() const {
  std::vector<Verdict> all;
  for (const auto& claim : claims()) {
    const auto found = models_.find(claim.id);
    if (found == models_.end()) continue;
    for (auto& verdict : claim.judge(found->second)) all.push_back(std::move(verdict));
  }
  return all;
}

std::vector<NamedPlot> Evidence::plots() const {
  std::vector<NamedPlot> all;
  for (const auto& claim : claims()) {
    const auto found = models_.find(claim.id);
    if (found == models_.end()) continue;
    for (auto& plot : claim.plots(found->second)) all.push_back(std::move(plot));
  }
  return all;
}

std::optional<Evidence::WorstCheck> Evidence::worst_check() const {
  WorstCheck worst{0, "", 0};
  for (const auto& cell : all_) {
    for (std::size_t i = 0; i < cell.checks.size(); ++i) {
      if (!cell.checks[i]) continue;
      ++worst.checks;
      if (std::fabs(cell.checks[i]->z) < worst.z) continue;
      worst.z = std::fabs(cell.checks[i]->z);
      worst.where = fmt::format("{} of {} at n = {}", cell.result.columns[i].column.name(), cell.result.model,
                                cell.result.n);
    }
  }
  if (worst.checks == 0) return std::nullopt;
  return worst;
}

}  // namespace ramify
