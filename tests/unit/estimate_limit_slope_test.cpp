// Extrapolated slopes on series whose limits are known, and what must not be taken for one.
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "ramify/estimate/limit_slope.hpp"

namespace ramify {
namespace {

using Series = std::function<double(double)>;

std::vector<KnownPoint> equal_steps(const Series& y, double step, int points, double error = 1e-13,
                                    double from = 10) {
  std::vector<KnownPoint> ladder;
  for (int i = 0; i < points; ++i) {
    const double x = from + i * step;
    ladder.push_back({x, y(x), error});
  }
  return ladder;
}

std::vector<KnownPoint> growing_steps(const Series& y, double from, double to, double error = 1e-12) {
  std::vector<KnownPoint> ladder;
  for (int i = 0; i < 16; ++i) {
    const double x = from * std::pow(to / from, i / 15.0);
    ladder.push_back({x, y(x), error});
  }
  return ladder;
}

void expect_found(const LimitSlope& slope, double limit, double widest) {
  EXPECT_LE(std::abs(slope.value - limit), slope.bound);
  EXPECT_LE(slope.bound, widest);
}

TEST(SettlingSlope, FindsTheLimitOfGeometricApproach) {
  for (const double rate : {0.3, 0.6, 0.8})
    expect_found(settling_slope(equal_steps([&](double x) { return 2 * x + 5 + std::pow(rate, x); }, 1, 12)),
                 2, 0.05);
  expect_found(settling_slope(equal_steps([](double x) { return 2 * x + std::pow(-0.7, x); }, 1, 12)), 2,
               0.1);
}

TEST(SettlingSlope, OfALineIsAsGoodAsItsPoints) {
  expect_found(settling_slope(equal_steps([](double x) { return 3 * x - 1; }, 1, 6, 1e-6)), 3, 1e-5);
}

TEST(SettlingSlope, IsUnknownWhereStepsDriftOrOscillate) {
  const auto drifting = equal_steps([](double x) { return 2 * x + std::log(x); }, 1, 12, 1e-13, 40);
  EXPECT_TRUE(std::isinf(settling_slope(drifting).bound));
  // A ladder of another factor than the period's: 0.9 of it.
  const auto wave = [](double x) { return 2 * x + 0.06 * std::sin(2 * 3.14159265358979 * x); };
  EXPECT_TRUE(std::isinf(settling_slope(equal_steps(wave, 0.9, 12)).bound));
  expect_found(settling_slope(equal_steps(wave, 1, 12)), 2, 1e-10);
}

TEST(SettlingSlope, ARivalIsExcludedByAFewPoints) {
  const auto ladder = equal_steps([](double x) { return x / std::log(3.0438278618) + std::exp(-x); }, 1, 6);
  const LimitSlope slope = settling_slope(ladder);
  EXPECT_GT(std::abs(slope.value - 1 / std::log(3.0)), slope.bound);
}

TEST(DriftingSlope, FindsTheLimitBehindSlowTerms) {
  const std::vector<Series> slow{
      [](double x) { return 4.311 * x - 1.953 * std::log(x) + 2; },
      [](double x) { return 4.311 * x - 1.953 * std::log(x) + 2 - 3 / std::sqrt(x) + std::log(x) / x; },
      [](double x) { return 0.4 * x + std::log(x + std::log(x)); },
      [](double x) { return 1.47 * x - 0.14 * std::log(x + 7) + 0.3 / std::sqrt(x + 1); },
      [](double x) { return 2 * x + 1.5 * std::log(x - 8); }};
  const std::vector<double> limits{4.311, 4.311, 0.4, 1.47, 2};
  for (std::size_t i = 0; i < slow.size(); ++i) {
    SCOPED_TRACE(i);
    expect_found(drifting_slope(growing_steps(slow[i], 25, 100)), limits[i], 0.01);
    expect_found(drifting_slope(growing_steps(slow[i], 250, 1000)), limits[i], 4e-4);
  }
}

TEST(DriftingSlope, OfAShortLadderIsWide) {
  const auto front = [](double x) { return 4.311 * x - 1.953 * std::log(x) + 2 - 3 / std::sqrt(x); };
  const LimitSlope near = drifting_slope(growing_steps(front, 3, 9, 1e-3));
  const LimitSlope far = drifting_slope(growing_steps(front, 250, 1000, 1e-3));
  expect_found(near, 4.311, HUGE_VAL);
  EXPECT_GT(near.bound, 10 * far.bound);
  EXPECT_LT(std::abs(4.311 - near.value - 0.05), near.bound) << "a rival 1 % off is still possible";
}

TEST(DriftingSlope, CountsTheErrorsOfItsPoints) {
  const auto front = [](double x) { return 4.311 * x - 1.953 * std::log(x); };
  EXPECT_GT(drifting_slope(growing_steps(front, 250, 1000, 1e-2)).bound,
            1e3 * drifting_slope(growing_steps(front, 250, 1000, 1e-7)).bound);
}

}  // namespace
}  // namespace ramify
