#include "ramify/fit/count_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/fit/bootstrap.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/fit/simulated_counts.hpp"
#include "ramify/fit/valley.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

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

/// Which orders Huber's loss holds to be odd.
std::string outlying_note(const CountFitness& fitness) {
  std::string orders;
  for (std::size_t k = 0; k < fitness.residuals.size(); ++k)
    if (const double z = fitness.residuals[k]; std::abs(z) > huber_scale)
      orders += fmt::format("{}{} ({:+.2g})", orders.empty() ? "" : ", ", k + 1, z);
  return fmt::format("Huber's loss beyond {} standard deviations: {}", huber_scale,
                     orders.empty() ? "no order is so far off" : "order " + orders + " counts less");
}

}  // namespace

std::string CountFitter::cannot_fit(const Family& family, Size n) {
  if (family.is_simulated()) return cannot_simulate(n);
  std::vector<double> values;
  for (const FamilyParameter& parameter : family.parameters) values.push_back(parameter.starts.front());
  return no_stream_counts(family.at(values), n);
}

CountSurface& CountFitter::surface(const Family& family, Size n) {
  auto& surface = surfaces_[{&family, n}];
  if (surface == nullptr)
    surface = std::make_unique<CountSurface>(family, n, workforce_.threads, *cancellation_);
  return *surface;
}

FamilyFit CountFitter::fit(const Family& family, const ObservedCounts& counts) {
  CountSurface& surface = this->surface(family, counts.n());
  const CountReading reading = counts.reading();
  while (true) {
    FamilyFit fit =
        fit_family(family, count_objective(surface, counts, density_), static_cast<double>(counts.n()));
    bool refined = false;
    for (const Point& place : fit.searched_places) refined |= surface.refine(place, reading);
    if (refined) continue;
    if (!fit.converged) return fit;
    fit.goodness = goodness_of(count_misfit(surface, counts, place_of(fit)), counts, fit.parameters.size());
    return fit;
  }
}

void CountFitter::settle(FamilyFit& fit, const ObservedCounts& counts) {
  const CountFitness fitness =
      count_fitness(surface(*fit.family, counts.n()), counts, place_of(fit), density_);
  fit.log_likelihood = fitness.log_likelihood;
  if (density_ == CountDensity::huber) add_note(fit.note, outlying_note(fitness));
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
  const auto refit = [&](const ObservedCounts& found) {
    ObservedCounts grown = found;
    grown.streams[0] = counts.streams[0];  // which a tree of forks of three may miss by one
    const Point place = best_place(family, count_objective(surface, grown, density_), start);
    return with_misfit(family.values(place), count_misfit(surface, grown, place));
  };
  Refits refits = refitted_counts(family.at(fit.estimates()), size_with_tips_of(family, counts.n()), plan,
                                  workforce_, *cancellation_, refit);
  const std::vector<double> misfits = take_misfits(refits, plan, fit);
  if (misfits.empty()) return;
  summarise_bootstrap(refits, fit);
  const auto larger = std::ranges::count_if(misfits.begin() + 1, misfits.end(),
                                            [&](double misfit) { return misfit >= misfits.front(); });
  fit.goodness.p_value = (1 + static_cast<double>(larger)) / (1 + static_cast<double>(plan.trees));
}

std::vector<double> CountFitter::grown_ratios(const NestedPair& pair, const ObservedCounts& counts,
                                              const BootstrapPlan& plan) {
  const Family& larger = *pair.larger->family;
  const Model simpler = pair.simpler->family->at({});
  CountSurface& surface = this->surface(larger, counts.n());
  // Laws are read accurately where fits of such trees lie: around that of the first.
  surface.refine(pair.place, counts.reading());
  refitted_counts(simpler, counts.n(), {1, plan.seed}, 1, *cancellation_, [&](const ObservedCounts& first) {
    const FamilyFit about = fit(larger, first);
    if (about.converged) refine_range(about, first, surface);
    return std::vector<double>{};
  });
  return only_numbers(refitted_counts(
      simpler, counts.n(), plan, workforce_, *cancellation_, [&](const ObservedCounts& grown) {
        return std::vector{likelihood_ratio(larger, count_objective(surface, grown, density_), pair.place)};
      }));
}

void CountFitter::trace_valley(FamilyFit& fit, const ObservedCounts& counts) {
  RAMIFY_EXPECTS(fit.family->mirror == Mirror::exchanged);
  CountSurface& surface = this->surface(*fit.family, counts.n());
  std::vector<ValleyStop> stops;
  for (bool refined = true; refined;) {
    stops = valley(count_objective(surface, counts, density_), place_of(fit));
    refined = false;
    for (const ValleyStop& stop : stops) refined |= surface.refine(stop.searched, counts.reading());
  }
  fit.valley.clear();
  for (const auto& [searched, place] : stops) {
    if (cancellation_->requested()) throw Interrupted();
    const std::vector<double> shapes = fit.family->values(searched);
    const auto ratio = horton_ratio_constant(fit.family->at(shapes));
    fit.valley.push_back({shapes[0], shapes[1],
                          count_fitness(surface, counts, searched, density_).log_likelihood,
                          ratio ? ratio->value : std::nan(""), place});
  }
}

}  // namespace ramify
