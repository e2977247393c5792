// Minima and profile intervals, of functions whose answers are known.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/optimise/minimum.hpp"
#include "ramify/optimise/profile.hpp"

namespace ramify {
namespace {

/// (1-x)^2 + 100 (y-x^2)^2: Rosenbrock's valley, 0 at (1,1).
Objective rosenbrock() {
  return {[](std::span<const double> at, double& value, double* gradient) {
            const double x = at[0], y = at[1], off = y - x * x;
            value = (1 - x) * (1 - x) + 100 * off * off;
            if (gradient != nullptr) {
              gradient[0] = -2 * (1 - x) - 400 * x * off;
              gradient[1] = 200 * off;
            }
            return true;
          },
          {-5, -5},
          {5, 5}};
}

/// (x^2-1)^2 + x/4: minima near -1 and 1, the lower one left.
Objective two_valleys() {
  return {[](std::span<const double> at, double& value, double* gradient) {
            const double x = at[0];
            value = (x * x - 1) * (x * x - 1) + x / 4;
            if (gradient != nullptr) gradient[0] = 4 * x * (x * x - 1) + 0.25;
            return true;
          },
          {-3},
          {3}};
}

/// ((x-1)^2 - 2 r (x-1) (y-2) + (y-2)^2) / (2 (1-r^2)): minus the logarithm of a normal density of
/// correlation r.
Objective correlated(double r, double low) {
  return {[r](std::span<const double> at, double& value, double* gradient) {
            const double x = at[0] - 1, y = at[1] - 2, scale = 1 - r * r;
            value = (x * x - 2 * r * x * y + y * y) / (2 * scale);
            if (gradient != nullptr) {
              gradient[0] = (x - r * y) / scale;
              gradient[1] = (y - r * x) / scale;
            }
            return true;
          },
          {low, -20},
          {20, 20}};
}

TEST(Minimum, OfRosenbrocksValley) {
  const Minimum minimum = minimise(rosenbrock(), {-1.2, 1});
  ASSERT_TRUE(minimum.converged);
  EXPECT_FALSE(minimum.at_end);
  EXPECT_NEAR(minimum.at[0], 1, 1e-9);
  EXPECT_NEAR(minimum.at[1], 1, 1e-9);
  EXPECT_NEAR(minimum.second(0, 0), 802, 1e-2);
  EXPECT_NEAR(minimum.second(0, 1), -400, 1e-2);
}

TEST(Minimum, AllOfThemAreListedTheLowestFirst) {
  const std::vector<Point> starts{{2.0}, {0.5}, {-2.0}, {-0.2}};
  const auto found = minima(two_valleys(), starts);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].at[0], -1.0298, 1e-3);
  EXPECT_NEAR(found[1].at[0], 0.9671, 1e-3);
  EXPECT_LT(found[0].value, found[1].value);
}

TEST(Minimum, AtAnEndOfTheBoxIsSaidToBeThere) {
  Objective above = two_valleys();
  above.low = {1.5};
  const Minimum minimum = minimise(above, {2.5});
  EXPECT_TRUE(minimum.at_end);
  EXPECT_TRUE(minimum.converged);
  EXPECT_EQ(minimum.at[0], 1.5);
}

TEST(Minimum, ItsCovarianceIsTheInverseOfTheCurvature) {
  const Minimum minimum = minimise(correlated(0.6, -20), {5, 5});
  const auto covariance = minimum.covariance();
  ASSERT_EQ(covariance.size(), 4u);
  EXPECT_NEAR(covariance[0], 1, 1e-7);
  EXPECT_NEAR(covariance[1], 0.6, 1e-7);
  EXPECT_NEAR(covariance[3], 1, 1e-7);
}

/// Minimised over y the function is (x-1)^2/2: at most 1.92 within 1.96 of 1, whatever the correlation.
TEST(Profile, EndsWhereTheFunctionHasRisenByHalfOfChiSquare) {
  for (const double r : {0.0, 0.6, 0.95}) {
    const Objective objective = correlated(r, -20);
    const auto interval = profile_interval(objective, minimise(objective, {5, 5}), 0);
    EXPECT_NEAR(interval.low.place[0], 1 - 1.9599639845400545, 1e-8) << r;
    EXPECT_NEAR(interval.high.place[0], 1 + 1.9599639845400545, 1e-8) << r;
    EXPECT_NEAR(interval.high.place[1], 2 + r * 1.9599639845400545, 1e-6) << r;
    EXPECT_FALSE(interval.low.is_open);
  }
}

TEST(Profile, IsOpenWhereTheBoxEndsFirst) {
  const Objective objective = correlated(0.6, 0);
  const auto interval = profile_interval(objective, minimise(objective, {5, 5}), 0);
  EXPECT_TRUE(interval.low.is_open);
  EXPECT_EQ(interval.low.place[0], 0);
  EXPECT_FALSE(interval.high.is_open);
}

}  // namespace
}  // namespace ramify
