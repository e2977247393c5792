#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/compare/judge.hpp"

namespace ramify {
namespace {

/// Means c log n + offset + bend / log n at geometric sizes.
std::vector<SizedMean> means(double c, double bend, double error) {
  std::vector<SizedMean> points;
  for (double n = 100; n < 2e6; n *= 3)
    points.push_back({n, c * std::log(n) + 0.7 + bend / std::log(n), error});
  return points;
}

TEST(Slope, FindsTheSlopeOfALineWhateverItsHeight) {
  const Slope slope = fit_slope(means(2, 0, 0.01));
  EXPECT_NEAR(slope.value, 2, 1e-12);
  EXPECT_DOUBLE_EQ(slope.smallest_n, 100);
}

TEST(Slope, StandardErrorOfTwoPointsIsElementary) {
  const Slope slope = fit_slope({{1, 5, 0.3}, {std::exp(2.0), 9, 0.4}});
  EXPECT_NEAR(slope.value, 2, 1e-12);
  EXPECT_NEAR(slope.standard_error, 0.5 / 2, 1e-12);
}

TEST(Slope, WeightsPointsByTheirErrors) {
  const Slope slope = fit_slope({{1, 0, 0.001}, {std::exp(1.0), 1, 0.001}, {std::exp(2.0), 50, 1000}});
  EXPECT_NEAR(slope.value, 1, 1e-3);
}

TEST(Growth, AStraightLineHasNoDrift) {
  EXPECT_NEAR(growth_constant(means(2, 0, 0.01)).drift, 0, 1e-10);
}

TEST(Growth, ABentOneStretchesTheIntervalTheWayItIsGoing) {
  const GrowthConstant growth = growth_constant(means(2, 5, 1e-6));
  EXPECT_GT(growth.drift, 0);
  const Interval interval = growth_interval(growth, Approach::drifts);
  EXPECT_NEAR(interval.upper - growth.slope.value, growth.drift, 1e-4);
  EXPECT_NEAR(growth.slope.value - interval.lower, 0, 1e-4);
}

TEST(Growth, NoiseIsNotTakenForDriftWhereTheLawSettles) {
  const GrowthConstant growth{{2, 0.1, 100, 1e6}, 0.2, 0.15};
  EXPECT_DOUBLE_EQ(growth_interval(growth, Approach::settles).upper, 2 + 0.1 * interval_sigmas);
  EXPECT_DOUBLE_EQ(growth_interval(growth, Approach::drifts).upper, 2.2 + 0.1 * interval_sigmas);
}

TEST(Judge, HasThreeStates) {
  EXPECT_EQ(judge({1.99, 2.01}, 2, 0.02), Outcome::reproduced);
  EXPECT_EQ(judge({1.90, 2.01}, 2, 0.02), Outcome::inconclusive);
  EXPECT_EQ(judge({1.90, 1.97}, 2, 0.02), Outcome::refuted);
  EXPECT_EQ(judge({2.03, 2.10}, 2, 0.02), Outcome::refuted);
  EXPECT_EQ(judge({1.00, 3.00}, 2, 0.02), Outcome::inconclusive)
      << "a wide interval around the truth is not a pass";
}

}  // namespace
}  // namespace ramify
