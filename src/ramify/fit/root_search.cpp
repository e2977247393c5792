#include "ramify/fit/root_search.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/fit/crossings.hpp"
#include "ramify/fit/local_root.hpp"

namespace ramify {
namespace {

constexpr std::size_t design_points = 7;
constexpr int design_attempts = 8;
constexpr double least_misfit = 1e-3;
// An estimator that took one value only still has a spread that more trees would show.
constexpr double least_relative_spread = 1e-3;

/// More trees where the scan asks for them; false where it asks for none.
bool add_points(const ResponseSurface& surface, RatioCurve& curve, const CrossingScan& scan,
                const SearchEffort& effort) {
  std::vector<ResponseRequest> requests;
  for (const double p : scan.undecided) {
    const std::uint64_t trees = curve.find(p)->trees;
    if (trees < 16 * effort.grid_trees) requests.push_back({p, 4 * trees});
  }
  for (const double p : scan.vertices) requests.push_back({p, 4 * effort.grid_trees});
  curve.merge(surface.sample(requests));
  return !requests.empty();
}

/// Equally spaced in log p over centre e^-half .. centre e^half, cut at 1/2.
std::vector<ResponseRequest> make_design(double centre, double half, std::uint64_t trees) {
  const double low = std::log(centre) - half, high = std::min(std::log(centre) + half, std::log(0.5));
  std::vector<ResponseRequest> design;
  for (std::size_t i = 0; i < design_points; ++i) {
    const double share = static_cast<double>(i) / (design_points - 1);
    design.push_back({std::min(0.5, std::exp(std::lerp(low, high, share))), trees});
  }
  return design;
}

std::vector<CurveSample> to_samples(std::span<const ResponsePoint> points, RatioEstimator estimator) {
  std::vector<CurveSample> samples;
  for (const ResponsePoint& point : points) {
    const ResponseSummary& summary = point[estimator];
    const double floor = least_relative_spread * summary.mean / std::sqrt(static_cast<double>(point.trees));
    samples.push_back({point.p, summary.mean, std::max(summary.standard_error, floor)});
  }
  return samples;
}

CurveRoot refine(const ResponseSurface& surface, RatioCurve& curve, RatioEstimator estimator, double target,
                 const Bracket& bracket, std::uint64_t trees) {
  double centre = bracket.guess;
  double half = std::min(surface.grid_step(centre), std::log(bracket.high / bracket.low));
  for (int attempt = 0; attempt < design_attempts; ++attempt) {
    const auto points = surface.sample(make_design(centre, half, trees));
    const LocalRoot root = solve_local_root(to_samples(points, estimator), target, centre, bracket.slope);
    const bool inside = root.p >= points.front().p && root.p <= points.back().p;
    if (root.converged && inside && root.slope * bracket.slope > 0 && root.misfit > least_misfit) {
      curve.merge(points);
      return {root.p, root.standard_error, true};
    }
    // The next design differs from this one, so its trees are new.
    const bool followed = root.converged && !inside && root.p > bracket.low && root.p < bracket.high;
    if (followed || (inside && root.converged)) centre = root.p;
    if (!followed) half /= 2;
  }
  return {centre, 0, false};
}

}  // namespace

RootSearch find_roots(const ResponseSurface& surface, RatioCurve& curve, RatioEstimator estimator,
                      double target, const SearchEffort& effort) {
  CrossingScan scan = scan_crossings(curve.points(), estimator, target);
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && scan.any_decided && add_points(surface, curve, scan, effort); ++round)
    scan = scan_crossings(curve.points(), estimator, target);
  RootSearch search{{}, std::move(scan.undecided), !scan.any_decided};
  for (const Bracket& bracket : scan.brackets)
    search.roots.push_back(refine(surface, curve, estimator, target, bracket, effort.root_trees));
  return search;
}

}  // namespace ramify
