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

/// d value / d searched.
double slope_of(const SearchScale& scale, double searched) {
  const double h = 1e-6 * std::max(1.0, std::abs(searched));
  return (scale.back(searched + h) - scale.back(searched - h)) / (2 * h);
}

FittedParameter fitted_parameter(const Family& family, const Objective& objective, const Minimum& best,
                                 std::size_t i) {
  const FamilyParameter& parameter = family.parameters[i];
  const std::vector<double> covariance = best.covariance();
  const double variance = covariance.empty() ? none : covariance[i * best.at.size() + i];
  ProfileInterval interval = profile_interval(objective, best, i);
  // Beyond 1/2 the mirror image begins.
  if (family.mirror == Mirror::reflected && interval.high.at > 0) interval.high = {0, false};
  return {parameter.name,
          parameter.scale.back(best.at[i]),
          best.at_end ? none : std::sqrt(variance) * slope_of(parameter.scale, best.at[i]),
          parameter.scale.back(interval.low.at),
          parameter.scale.back(interval.high.at),
          interval.low.is_open,
          interval.high.is_open};
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

FamilyFit fit_family(const Family& family, const Objective& objective, double observations) {
  FamilyFit fit{&family, {}, none, observations, true, false, {}, {}};
  if (family.parameters.empty()) {
    fit.log_likelihood = -objective.value({});
    return fit;
  }
  std::vector<Minimum> found;
  for (Minimum& minimum : minima(objective, folded_starts(family))) {
    minimum.at = folded(family, minimum.at);
    const bool is_new = std::ranges::none_of(found, [&](const Minimum& other) {
      return std::ranges::equal(other.at, minimum.at,
                                [](double a, double b) { return std::abs(a - b) < 1e-4; });
    });
    if (is_new) found.push_back(std::move(minimum));
  }
  const Minimum& best = found.front();
  fit.log_likelihood = -best.value;
  fit.converged = best.converged;
  fit.at_end = best.at_end;
  for (std::size_t i = 0; i < best.at.size(); ++i)
    fit.parameters.push_back(fitted_parameter(family, objective, best, i));
  for (const Minimum& other : found)
    if (&other != &best && other.converged && !other.at_end && other.value < best.value + relevant)
      fit.other_optima.push_back(family.values(other.at));
  return fit;
}

}  // namespace ramify
