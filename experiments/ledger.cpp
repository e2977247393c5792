#include "ledger.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "ramify/compare/judge.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/run/plan.hpp"

namespace ramify {
namespace {

/// Of all means of a ledger together one of a million ledgers whose samplers are right has one beyond it.
constexpr double false_alarm = 1e-6;

ModelCells& cells_of(std::vector<ModelCells>& models, const Model& model) {
  auto place = std::ranges::find(models, model, &ModelCells::model);
  if (place == models.end()) place = models.insert(models.end(), ModelCells{model, {}});
  return *place;
}

/// Calls seen(cell, column, |z|) for every mean of a cell that has an exact value.
template <class Seen>
void for_each_check(const CheckedCell& cell, Seen seen) {
  for (std::size_t i = 0; i < cell.checks.size(); ++i)
    if (cell.checks[i]) seen(cell.result.columns[i].column, std::abs(cell.checks[i]->z));
}

/// Throws Error where the basis is not a number and an interval about it.
void require_numbers(const Basis& basis) {
  const Interval& interval = basis.interval;
  if (std::isfinite(basis.estimate) && interval.lower <= basis.estimate && basis.estimate <= interval.upper)
    return;
  throw Error(fmt::format("its estimate is {} in [{}, {}]", basis.estimate, interval.lower, interval.upper),
              "that is no interval about a number", "please report it");
}

}  // namespace

void Ledger::add(const RunConfig& config, const CheckedRun& run) {
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
  for (const auto& cell : run.cells) for_each_check(cell, [&](const StatisticColumn&, double) { ++means_; });
  all_.insert(all_.end(), run.cells.begin(), run.cells.end());
}

std::vector<const Claim*> Ledger::served() const {
  return claims_among([this](std::string_view id) { return models_.contains(id); });
}

SamplerCheck Ledger::sampler_check(const Claim& claim, const ClaimPart& part) const {
  SamplerCheck check{0, 0, simultaneous_sigmas(false_alarm, means_), part.model.has_value()};
  const auto models = models_.find(claim.id);
  if (models == models_.end()) return check;
  for (const ModelCells& cells : models->second) {
    if (cells.model != part.model) continue;
    for (const auto& cell : cells.cells)
      for_each_check(cell, [&](const StatisticColumn& column, double z) {
        if (column.statistic != part.statistic) return;
        ++check.means;
        check.worst_z = std::max(check.worst_z, z);
      });
  }
  return check;
}

Ledger::Judged Ledger::judged(const std::vector<const Claim*>& claims, GrowthLimits& limits, unsigned threads,
                              const Cancellation& cancellation) const {
  struct Place {
    const Claim* claim;
    const ClaimPart* part;
    std::optional<Basis> basis = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
    std::string failure = {};         // NOLINT(readability-redundant-member-init): likewise
  };
  std::vector<Place> places;
  for (const Claim* claim : claims)
    for (const ClaimPart& part : claim->parts) places.push_back({claim, &part});
  parallel_for(places.size(), threads, [&](std::size_t i, unsigned) {
    try {
      places[i].basis = places[i].part->basis({limits, cancellation});
      require_numbers(*places[i].basis);
    } catch (const Error& error) {
      places[i].basis.reset();
      places[i].failure = error.what();
    }
  });
  Judged judged;
  for (const auto& [claim, part, basis, failure] : places) {
    if (basis)
      judged.verdicts.push_back(
          {{part->statement, *basis}, judge(part->statement, basis->interval), sampler_check(*claim, *part)});
    else
      judged.failures.push_back(fmt::format("{} cannot be judged: {}", part->statement.part, failure));
  }
  return judged;
}

std::vector<NamedPlot> Ledger::plots() const {
  std::vector<NamedPlot> all;
  for (const Claim* claim : served())
    for (auto& plot : claim->plots(models_.at(claim->id))) all.push_back(std::move(plot));
  return all;
}

Ledger::WorstCheck Ledger::worst_check() const {
  WorstCheck worst{{means_, 0, simultaneous_sigmas(false_alarm, means_)}, ""};
  for (const auto& cell : all_)
    for_each_check(cell, [&](const StatisticColumn& column, double z) {
      if (z < worst.check.worst_z) return;
      worst.check.worst_z = z;
      worst.where = fmt::format("{} of {} at n = {}", column.name(), cell.result.model, cell.result.n);
    });
  return worst;
}

}  // namespace ramify
