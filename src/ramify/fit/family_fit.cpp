#include "ramify/fit/family_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double relevant = 20;  // of a log-likelihood: maxima that lie lower are not listed

/// The minimum at the folded point: its curvature goes with its parameters.
Minimum folded(const Family& family, Minimum minimum) {
  Point at = folded(family, minimum.at);
  if (family.mirror == Mirror::exchanged && at != minimum.at) std::ranges::reverse(minimum.curvature);
  minimum.at = std::move(at);
  return minimum;
}

/// Starts beyond the mirror find nothing new.
std::vector<Point> folded_starts(const Family& family) {
  std::vector<Point> starts;
  for (const Point& start : family.starts())
    if (start == folded(family, start)) starts.push_back(start);
  return starts;
}

/// A pair in order, from one of its parameters and the distance d >= 0 to the other: (x, x+d) where the first
/// is kept, (x-d, x) where the second is.
Point pair_of(std::span<const double> at, std::size_t kept) {
  return kept == 0 ? Point{at[0], at[0] + at[1]} : Point{at[0] - at[1], at[0]};
}

/// The function of what pair_of() takes: so the pair stays in order.
Objective ordered(const Objective& objective, std::size_t kept) {
  const auto evaluate = [objective, kept](std::span<const double> at, double& value, double* gradient) {
    const Point pair = pair_of(at, kept);
    std::array<double, 2> slopes{};
    if (!objective.contains(pair) ||
        !objective.evaluate(pair, value, gradient == nullptr ? nullptr : slopes.data()))
      return false;
    if (gradient != nullptr) {
      gradient[0] = slopes[0] + slopes[1];
      gradient[1] = kept == 0 ? slopes[1] : -slopes[0];
    }
    return true;
  };
  return {evaluate, {objective.low[kept], 0}, {objective.high[kept], objective.high[1] - objective.low[0]}};
}

/// Where the mirror image begins the interval ends: in the middle of a scale, or where the pair is no longer
/// in order.
ProfileInterval interval_of(const Family& family, const Objective& objective, const Minimum& best,
                            std::size_t i) {
  if (family.mirror == Mirror::exchanged) {
    const Objective in_order = ordered(objective, i);
    const Minimum same = minimise(in_order, {best.at[i], best.at[1] - best.at[0]});
    const Point equal{0};
    ProfileInterval interval = profile_interval(in_order, same, 0, rise_of_95, std::span(&equal, 1));
    for (ProfileEnd* end : {&interval.low, &interval.high}) end->place = pair_of(end->place, i);
    return interval;
  }
  ProfileInterval interval = profile_interval(objective, best, i);
  if (family.mirror == Mirror::reflected && interval.high.place[0] > 0) interval.high = {{0}, false};
  return interval;
}

/// Without errors where the fit did not converge.
void add_parameter(const Objective& objective, const Minimum& best, std::size_t i, FamilyFit& fit) {
  const FamilyParameter& parameter = fit.family->parameters[i];
  const SearchScale& scale = parameter.scale;
  FittedParameter fitted{parameter.name, scale.back(best.at[i]), none, none, none, false, false};
  if (best.converged) {
    const double variance = fit.covariance.empty() ? none : fit.covariance[i * best.at.size() + i];
    const ProfileInterval interval = interval_of(*fit.family, objective, best, i);
    fitted = {parameter.name,
              fitted.estimate,
              std::sqrt(variance) * scale.slope(best.at[i]),
              scale.back(interval.low.place[i]),
              scale.back(interval.high.place[i]),
              interval.low.is_open,
              interval.high.is_open};
    fit.searched_places.push_back(interval.low.place);
    fit.searched_places.push_back(interval.high.place);
  }
  fit.parameters.push_back(fitted);
}

/// The minima that can be told apart, the lowest first.
std::vector<Minimum> folded_minima(const Family& family, const Objective& objective) {
  std::vector<Minimum> found;
  for (const Minimum& unfolded : minima(objective, folded_starts(family))) {
    Minimum minimum = folded(family, unfolded);
    if (std::ranges::none_of(found, [&](const Minimum& other) { return are_same(other, minimum); }))
      found.push_back(std::move(minimum));
  }
  return found;
}

}  // namespace

double FamilyFit::aic() const {
  return 2 * (static_cast<double>(parameters.size() - dependent) - log_likelihood);
}

double FamilyFit::bic() const {
  return static_cast<double>(parameters.size() - dependent) * std::log(observations) - 2 * log_likelihood;
}

std::vector<double> FamilyFit::estimates() const {
  std::vector<double> found;
  for (const FittedParameter& parameter : parameters) found.push_back(parameter.estimate);
  return found;
}

Point folded(const Family& family, Point at) {
  if (family.mirror == Mirror::reflected) at[0] = -std::abs(at[0]);
  if (family.mirror == Mirror::exchanged) std::ranges::sort(at);
  return at;
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
  return {&family, {}, none, observations, true, false, {}, {}, {}, {none, none, 0, 0}, {}, {}, {}};
}

FamilyFit fit_family(const Family& family, const Objective& minus_log_likelihood, double observations) {
  const Objective& objective = minus_log_likelihood;
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

Point best_place(const Family& family, const Objective& minus_log_likelihood, const Point& start) {
  if (family.parameters.empty()) return start;
  std::vector<Point> starts = folded_starts(family);
  starts.push_back(start);
  const std::vector<Minimum> found = minima(minus_log_likelihood, starts);
  return found.empty() ? start : folded(family, found.front().at);
}

void rank(std::vector<FamilyFit>& fits) {
  std::ranges::stable_sort(fits, [](const FamilyFit& a, const FamilyFit& b) {
    if (std::isnan(a.aic()) || std::isnan(b.aic())) return !std::isnan(a.aic()) && std::isnan(b.aic());
    return a.aic() < b.aic();
  });
}

}  // namespace ramify
