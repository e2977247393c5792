// The valley of equivalent shapes, of a function whose valley is known.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/fit/valley.hpp"
#include "ramify/fit/valley_table.hpp"

namespace ramify {
namespace {

constexpr double product = 12, middle = 3, steepness = 5;

/// 50 (log ab - log 12)^2 + 5 (log(a+b) - 3)^2: the valley is ab = 12, its bottom a+b = e^3.
Objective known_valley() {
  const auto evaluate = [](std::span<const double> at, double& value, double* gradient) {
    const double a = std::exp(at[0]), b = std::exp(at[1]);
    const double across = at[0] + at[1] - std::log(product), along = std::log(a + b) - middle;
    value = 50 * across * across + steepness * along * along;
    if (gradient != nullptr) {
      gradient[0] = 100 * across + 2 * steepness * along * a / (a + b);
      gradient[1] = 100 * across + 2 * steepness * along * b / (a + b);
    }
    return true;
  };
  return {evaluate, {-3, -3}, {6, 6}};
}

TEST(Valley, FollowsTheBestPairsFromEndToEndOfTheRegion) {
  const auto stops = valley(known_valley(), {0, 3});
  ASSERT_EQ(stops.size(), 26u);
  const double half = std::sqrt(rise_of_two / steepness);
  double before = 0;
  for (const ValleyStop& stop : stops) {
    const double a = std::exp(stop.searched[0]), b = std::exp(stop.searched[1]);
    EXPECT_LE(a, b);
    EXPECT_NEAR(a * b / product, 1, 1e-5);
    EXPECT_GE(a + b, before);
    before = a + b;
    if (stop.place == ValleyPoint::Place::estimate) {
      EXPECT_NEAR(std::log(a + b), middle, 1e-6);
    }
  }
  const auto sum_of = [](const ValleyStop& stop) {
    return std::log(std::exp(stop.searched[0]) + std::exp(stop.searched[1]));
  };
  EXPECT_NEAR(sum_of(stops.front()), middle - half, 1e-4);
  EXPECT_NEAR(sum_of(stops.back()), middle + half, 1e-4);
  EXPECT_EQ(stops.front().place, ValleyPoint::Place::end);
  EXPECT_EQ(stops.back().place, ValleyPoint::Place::end);
}

/// Where what is searched ends before the region does, that is said.
TEST(Valley, IsOpenWhereTheSearchEnds) {
  Objective objective = known_valley();
  objective.high = {2.9, 2.9};  // b at most e^2.9, below the end at b = e^3.77
  const auto stops = valley(objective, {0, 2.8});
  EXPECT_EQ(stops.back().place, ValleyPoint::Place::open_end);
  EXPECT_NEAR(stops.back().searched[1], 2.9, 1e-3);
}

TEST(Valley, IsATableAndAPicture) {
  FamilyFit fit = without_fit(find_family("beta"), 99);
  fit.log_likelihood = -3;
  fit.valley = {{1, 2, -5, 3.2, ValleyPoint::Place::end},
                {1.5, 4, -3, 3.25, ValleyPoint::Place::estimate},
                {2, 9, -4.5, 3.3, ValleyPoint::Place::open_end}};
  const std::vector<FittedDatum> data{{"oak", "orders", 99, "", {fit, without_fit(find_family("bst"), 99)}}};
  const Table table = valley_table(data);
  ASSERT_EQ(table.rows(), 3u);
  EXPECT_EQ(table.number(0, "below_best"), 2);
  EXPECT_EQ(table.number(1, "below_best"), 0);
  EXPECT_EQ(to_text(table.at(2, "place")), "open end");
  EXPECT_EQ(table.number(2, "horton_ratio"), 3.3);
  const Plot plot = valley_plot(data);
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_EQ(plot.series[0].curve.size(), 3u);
  ASSERT_EQ(plot.series[0].points.size(), 1u);
  EXPECT_EQ(plot.series[0].points[0].y, 4);
  EXPECT_NE(plot.subtitle.find("R(a,b) 3.2 to 3.3"), std::string::npos) << plot.subtitle;
}

}  // namespace
}  // namespace ramify
