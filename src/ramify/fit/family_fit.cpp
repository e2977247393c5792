#include "ramify/fit/family_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double relevant = 20;  // of a log-likelihood: maxima that lie lower are not listed

/// The point that stands for it among those that nobody can tell apart.
Point folded(const Family& family, Point at) {
  if (family.mirror == Mirror::reflected) at[0] = -std::abs(at[0]);
  if (family.mirror == Mirror::exchanged) std::ranges::sort(at);
  return at;
}

/// Starts beyond the mirror find nothing new.
std::vector<Point> folded_starts(const Family& family) {
  std::vector<Point> starts;
  for (const Point& start : family.starts())
    if (start == folded(family, start)) starts.push_back(start);
  return starts;
}

/// Beyond the middle of a scale its mirror image begins.
ProfileInterval folded(const Family& family, ProfileInterval interval) {
  if (family.mirror == Mirror::reflected && interval.high.place[0] > 0) interval.high = {{0}, false};
  return interval;
}

void add_parameter(const Objective& objective, const Minimum& best, std::size_t i, FamilyFit& fit) {
  const FamilyParameter& parameter = fit.family->parameters[i];
  const double variance = fit.covariance.empty() ? none : fit.covariance[i * best.at.size() + i];
  const ProfileInterval interval = folded(*fit.family, profile_interval(objective, best, i));
  const SearchScale& scale = parameter.scale;
  fit.parameters.push_back({parameter.name, scale.back(best.at[i]),
                            std::sqrt(variance) * scale.slope(best.at[i]), scale.back(interval.low.place[i]),
                            scale.back(interval.high.place[i]), interval.low.is_open, interval.high.is_open});
  fit.searched_places.push_back(interval.low.place);
  fit.searched_places.push_back(interval.high.place);
}

/// The minima that can be told apart, the lowest first.
std::vector<Minimum> folded_minima(const Family& family, const Objective& objective) {
  std::vector<Minimum> found;
  for (Minimum& minimum : minima(objective, folded_starts(family))) {
    minimum.at = folded(family, minimum.at);
    const bool is_new = std::ranges::none_of(found, [&](const Minimum& other) {
      return std::ranges::equal(other.at, minimum.at,
                                [](double a, double b) { return std::abs(a - b) < 1e-4; });
    });
    if (is_new) found.push_back(std::move(minimum));
  }
  return found;
}

}  // namespace

double FamilyFit::aic() const {
  return 2 * (static_cast<double>(parameters.size()) - log_likelihood);
}

double FamilyFit::bic() const {
  return static_cast<double>(parameters.size()) * std::log(observations) - 2 * log_likelihood;
}

std::vector<double> FamilyFit::estimates() const {
  std::vector<double> found;
  for (const FittedParameter& parameter : parameters) found.push_back(parameter.estimate);
  return found;
}

SearchBox search_box(const Family& family) {
  SearchBox box;
  for (const FamilyParameter& parameter : family.parameters) {
    box.low.push_back(parameter.scale.of(parameter.lowest));
    box.high.push_back(parameter.scale.of(parameter.highest));
  }
  return box;
}

FamilyFit without_fit(const Family& family, double observations) {
  return {&family, {}, none, observations, true, false, {}, {}, {}, {none, none, 0, 0}, {}, {}};
}

FamilyFit fit_family(const Family& family, const Objective& objective, double observations) {
  FamilyFit fit = without_fit(family, observations);
  if (family.parameters.empty()) {
    fit.log_likelihood = -objective.value({});
    return fit;
  }
  const std::vector<Minimum> found = folded_minima(family, objective);
  if (found.empty()) {
    fit.converged = false;
    fit.note = "the likelihood has no value where it is searched";
    return fit;
  }
  const Minimum& best = found.front();
  fit.log_likelihood = -best.value;
  fit.converged = best.converged;
  fit.at_end = best.at_end;
  if (!best.at_end) fit.covariance = best.covariance();
  fit.searched_places.push_back(best.at);
  for (std::size_t i = 0; i < best.at.size(); ++i) add_parameter(objective, best, i, fit);
  for (const Minimum& other : found) {
    if (&other == &best || !other.converged || other.at_end || other.value > best.value + relevant) continue;
    fit.other_optima.push_back(family.values(other.at));
    fit.searched_places.push_back(other.at);
  }
  return fit;
}

Point best_place(const Family& family, const Objective& objective, const Point& start) {
  std::vector<Point> starts = folded_starts(family);
  starts.push_back(start);
  const std::vector<Minimum> found = minima(objective, starts);
  return found.empty() ? start : folded(family, found.front().at);
}

}  // namespace ramify
