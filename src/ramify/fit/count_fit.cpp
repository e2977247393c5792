#include "ramify/fit/count_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "ramify/fit/bootstrap.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/sample/grow_blocks.hpp"

namespace ramify {
namespace {

/// Points of the bootstrap's range on either side of the estimate, in standard errors.
constexpr std::array<double, 4> range{-4, -2, 2, 4};

/// Chi-square, but for the parameters, where the family is right and the counts are Gaussian.
Goodness goodness_of(double misfit, const ObservedCounts& counts, std::size_t parameters) {
  const double degrees = static_cast<double>(counts.reading().orders) - static_cast<double>(parameters);
  return {misfit, degrees > 0 ? boost::math::gamma_q(degrees / 2, misfit / 2) : std::nan(""), 0, degrees};
}

Point place_of(const FamilyFit& fit) {
  return fit.family->searched(fit.estimates());
}

}  // namespace

std::string CountFitter::cannot_fit(const Family& family, Size n) {
  std::vector<double> values;
  for (const FamilyParameter& parameter : family.parameters) values.push_back(parameter.starts.front());
  return no_stream_counts(family.at(values), n);
}

CountSurface& CountFitter::surface(const Family& family, Size n) {
  auto& surface = surfaces_[{&family, n}];
  if (surface == nullptr) surface = std::make_unique<CountSurface>(family, n, threads_, *cancellation_);
  return *surface;
}

FamilyFit CountFitter::fit(const Family& family, const ObservedCounts& counts) {
  CountSurface& surface = this->surface(family, counts.n());
  const CountReading reading = counts.reading();
  while (true) {
    FamilyFit fit = fit_family(family, count_objective(surface, counts), static_cast<double>(counts.n()));
    bool refined = false;
    for (const Point& place : fit.searched_places) refined |= surface.refine(place, reading);
    if (refined) continue;
    if (!fit.converged) return fit;
    fit.goodness = goodness_of(count_misfit(surface, counts, place_of(fit)), counts, fit.parameters.size());
    return fit;
  }
}

void CountFitter::settle(FamilyFit& fit, const ObservedCounts& counts) {
  const CountFitness fitness = count_fitness(surface(*fit.family, counts.n()), counts, place_of(fit));
  fit.log_likelihood = fitness.log_likelihood;
  fit.goodness = goodness_of(fitness.misfit, counts, fit.parameters.size());
}

void CountFitter::refine_range(const FamilyFit& fit, const ObservedCounts& counts, CountSurface& surface) {
  const Point centre = place_of(fit);
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const SearchScale& scale = fit.family->parameters[i].scale;
    const double half = (scale.of(fit.parameters[i].upper) - scale.of(fit.parameters[i].lower)) / 4;
    for (const double errors : range) {
      Point place = centre;
      place[i] += errors * half;
      surface.refine(place, counts.reading());
    }
  }
}

void CountFitter::bootstrap(FamilyFit& fit, const ObservedCounts& counts, const BootstrapPlan& plan) {
  const Family& family = *fit.family;
  CountSurface& surface = this->surface(family, counts.n());
  refine_range(fit, counts, surface);
  const Point start = place_of(fit);
  std::vector<std::vector<double>> estimates(plan.trees);
  std::vector<double> misfits(plan.trees);
  const GrowingJob job{
      family.at(fit.estimates()), counts.n(), plan.seed, {orders_and_height, true}, 0, plan.trees, 64};
  grow_blocks({job}, threads_, *cancellation_, [&](const Block&, const BlockTrees& trees) {
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      const auto top = measures.streams.begin() + measures.strahler + 1;
      const ObservedCounts grown{{measures.streams.begin(), top}};
      const Point place = best_place(family, count_objective(surface, grown), start);
      estimates[replicate] = family.values(place);
      misfits[replicate] = count_misfit(surface, grown, place);
    });
  });
  summarise_bootstrap(estimates, fit);
  const auto larger =
      std::ranges::count_if(misfits, [&fit](double misfit) { return misfit >= fit.goodness.statistic; });
  fit.goodness.trees = plan.trees;
  fit.goodness.p_value = (1 + static_cast<double>(larger)) / (1 + static_cast<double>(plan.trees));
}

}  // namespace ramify
