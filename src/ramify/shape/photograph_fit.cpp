#include "ramify/shape/photograph_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/optimise/least_squares.hpp"
#include "ramify/optimise/root_between.hpp"
#include "ramify/shape/deviation_rule.hpp"

namespace ramify {
namespace {

constexpr double usual_peak = 0.5;

void require_silhouette(const Silhouette& tree) {
  if (tree.base > 0 && tree.height > tree.base && tree.lateral >= 0 &&
      std::isfinite(tree.height + tree.lateral))
    return;
  throw Error(fmt::format("base {:g}, height {:g}, lateral {:g}", tree.base, tree.height, tree.lateral),
              "the base lies between 0 and the height, the lateral extent is not negative",
              "measure all three in one unit");
}

Contraction with_secondary(const Silhouette& tree, double main) {
  return {main, main * tree.lateral / (tree.height - tree.base)};
}

/// What is linear in two parameters: residual i is slope_i a + offset_i b - value_i.
LeastSquares fit_line(std::span<const double> slopes, std::span<const double> offsets,
                      std::span<const double> values, const Point& start) {
  const auto evaluate = [=](std::span<const double> at, std::span<double> residuals, double* jacobian) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      residuals[i] = slopes[i] * at[0] + offsets[i] * at[1] - values[i];
      if (jacobian == nullptr) continue;
      jacobian[2 * i] = slopes[i];
      jacobian[2 * i + 1] = offsets[i];
    }
    return true;
  };
  return least_squares({evaluate, values.size()}, start);
}

}  // namespace

Contraction approximate_contraction(const Silhouette& tree) {
  require_silhouette(tree);
  return with_secondary(tree, 1 - tree.base / tree.height);
}

Contraction exact_contraction(const Silhouette& tree, unsigned levels) {
  require_silhouette(tree);
  RAMIFY_EXPECTS(levels >= 1);
  const double wanted = tree.height / tree.base;
  const auto excess = [&](double ratio) {
    double sum = 1;
    for (unsigned level = 0; level < levels; ++level) sum = 1 + ratio * sum;
    return sum - wanted;
  };
  return with_secondary(tree, root_between(excess, 0, wanted));
}

ContractionEstimate contraction_by_level(std::span<const double> levels, std::span<const double> lengths) {
  RAMIFY_EXPECTS(levels.size() == lengths.size());
  const auto [first, last] = std::ranges::minmax(levels);
  if (lengths.size() < 3 || first == last || !(std::ranges::min(lengths) > 0))
    throw Error(fmt::format("{} lengths", lengths.size()),
                "a gradient with an interval wants three lengths above 0, of two levels or more",
                "measure more branches");
  std::vector<double> logs;
  for (const double length : lengths) logs.push_back(std::log(length));
  const std::vector<double> ones(levels.size(), 1);
  const LeastSquares fit = fit_line(levels, ones, logs, {0, 0});
  const double freedom = static_cast<double>(lengths.size()) - 2;
  const double error = std::sqrt(fit.variance(0) * fit.sum_of_squares / freedom);
  constexpr double upper_tenth = 0.9;  // of an interval of 80 %
  const double reach = boost::math::quantile(boost::math::students_t(freedom), upper_tenth) * error;
  return {std::exp(fit.at[0]), std::exp(fit.at[0] - reach), std::exp(fit.at[0] + reach)};
}

LevelAngles fit_level_angles(const AnglesByHeight& angles, int category) {
  RAMIFY_EXPECTS(category >= 1 && category <= 5);
  const auto share = [&](double tau) { return level_share(category, tau, usual_peak); };
  // Shares are cubics at most: Simpson's rule is their mean.
  const std::array highest{(share(0) + 4 * share(0.5) + share(1)) / 6, share(0), share(1)};
  std::array<double, 3> lowest{};
  for (std::size_t i = 0; i < 3; ++i) lowest[i] = 1 - highest[i];
  const std::array values{angles.average, angles.bottom, angles.top};
  const LeastSquares fit = fit_line(highest, lowest, values, {angles.bottom, angles.top});
  return {fit.at[0], fit.at[1], std::sqrt(fit.sum_of_squares / 3)};
}

}  // namespace ramify
