// Minima in boxes and profile intervals, of functions whose answers are known.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/optimise/profile.hpp"

namespace ramify {
namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();

/// (x-1)^2 + 2 (y - x)^2
Objective valley(Point low, Point high) {
  const auto evaluate = [](std::span<const double> at, double& value, double* gradient) {
    const double x = at[0] - 1, off = at[1] - at[0];
    value = x * x + 2 * off * off;
    if (gradient != nullptr) {
      gradient[0] = 2 * x - 4 * off;
      gradient[1] = 4 * off;
    }
    return true;
  };
  return {evaluate, std::move(low), std::move(high)};
}

/// cosh(x) - slope x
Objective cosh_of(double slope, double low, double high) {
  const auto evaluate = [slope](std::span<const double> at, double& value, double* gradient) {
    value = std::cosh(at[0]) - slope * at[0];
    if (gradient != nullptr) gradient[0] = std::sinh(at[0]) - slope;
    return true;
  };
  return {evaluate, {low}, {high}};
}

TEST(OptimiseMinimum, IsFoundInside) {
  const Minimum minimum = minimise(valley({-no_end, -no_end}, {no_end, no_end}), {7, -3});
  EXPECT_TRUE(minimum.converged);
  EXPECT_FALSE(minimum.at_end);
  EXPECT_NEAR(minimum.at[0], 1, 1e-9);
  EXPECT_NEAR(minimum.at[1], 1, 1e-9);
  // Second derivatives 6, -4, 4, whose inverse is 1/2, 1/2, 3/4.
  EXPECT_NEAR(minimum.second(0, 0), 6, 1e-6);
  EXPECT_NEAR(minimum.covariance()[3], 0.75, 1e-6);
}

TEST(OptimiseMinimum, IsFoundAtAnEndFromAfar) {
  for (const double start : {-2.9, 0.0, 2.9}) {
    const Minimum minimum = minimise(cosh_of(50, -3, 3), {start});
    EXPECT_TRUE(minimum.converged && minimum.at_end) << start;
    EXPECT_EQ(minimum.at[0], 3) << start;
  }
}

TEST(OptimiseProfile, EndsWhereTheFunctionHasRisen) {
  // Of x the profile is (x-1)^2; of y, minimised over x = (1+2y)/3, it is 2/3 (y-1)^2.
  const Objective objective = valley({-no_end, -no_end}, {no_end, no_end});
  const Minimum minimum = minimise(objective, {0, 0});
  const ProfileInterval x = profile_interval(objective, minimum, 0, 4);
  EXPECT_NEAR(x.low.place[0], -1, 1e-8);
  EXPECT_NEAR(x.high.place[0], 3, 1e-8);
  EXPECT_NEAR(x.high.place[1], 3, 1e-6);
  const ProfileInterval y = profile_interval(objective, minimum, 1, 6);
  EXPECT_NEAR(y.low.place[1], -2, 1e-8);
  EXPECT_NEAR(y.high.place[1], 4, 1e-8);
  EXPECT_FALSE(y.high.is_open);
}

TEST(OptimiseProfile, IsOpenWhereTheBoxEndsBefore) {
  const Objective objective = cosh_of(0, -1, 10);
  const ProfileInterval interval = profile_interval(objective, minimise(objective, {0.5}), 0, 2);
  EXPECT_TRUE(interval.low.is_open);
  EXPECT_EQ(interval.low.place[0], -1);
  EXPECT_FALSE(interval.high.is_open);
  EXPECT_NEAR(interval.high.place[0], std::acosh(3), 1e-9);
}

/// In y two hollows, at -1 and 1: x^2 + 8 (y^2-1)^2 + x y. Along y = 1 the function rises with x and falls
/// along y = -1.
TEST(OptimiseProfile, GoesOnAlongALowerMinimumElsewhere) {
  const auto evaluate = [](std::span<const double> at, double& value, double* gradient) {
    const double x = at[0], y = at[1], off = y * y - 1;
    value = x * x / 16 + 8 * off * off + x * y;
    if (gradient != nullptr) {
      gradient[0] = x / 8 + y;
      gradient[1] = 32 * off * y + x;
    }
    return true;
  };
  const Objective objective{evaluate, {-4, -3}, {4, 3}};
  const Minimum start{{0, 1}, 0, {0.125, 1, 1, 64}, true, false};
  const Point elsewhere{-1};
  const ProfileInterval own = profile_interval(objective, start, 0, 1);
  const ProfileInterval both = profile_interval(objective, start, 0, 1, std::span(&elsewhere, 1));
  EXPECT_LT(own.high.place[0], 1.1);
  EXPECT_TRUE(both.high.is_open);  // x/16 - 1 < 0 all the way along y = -1
}

}  // namespace
}  // namespace ramify
