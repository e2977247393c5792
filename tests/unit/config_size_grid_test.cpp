#include <cmath>

#include <gtest/gtest.h>

#include "ramify/config/replicate_rule.hpp"
#include "ramify/config/size_grid.hpp"
#include "ramify/core/error.hpp"

namespace ramify {
namespace {

using Sizes = std::vector<Size>;

TEST(GeometricGrid, HoldsBothEndsAndRoundsBetween) {
  EXPECT_EQ(geometric_grid(100, 1'000'000, 9),
            (Sizes{100, 316, 1000, 3162, 10000, 31623, 100000, 316228, 1000000}));
  EXPECT_EQ(geometric_grid(1, 4, 3), (Sizes{1, 2, 4}));
  EXPECT_EQ(geometric_grid(7, 7, 1), (Sizes{7}));
}

TEST(GeometricGrid, DropsEqualSizes) {
  EXPECT_EQ(geometric_grid(1, 4, 9), (Sizes{1, 2, 3, 4}));
}

TEST(GeometricGrid, ExactBeyondTheReachOfADouble) {
  // 2^62 = 2^0 (2^31)^2, and an odd neighbour that no double holds.
  EXPECT_EQ(geometric_grid(1, max_size, 3), (Sizes{1, Size{1} << 31, max_size}));
  EXPECT_EQ(geometric_grid(max_size - 2, max_size, 3), (Sizes{max_size - 2, max_size - 1, max_size}));
}

TEST(GeometricGrid, RefusesWhatIsNoGrid) {
  EXPECT_THROW(geometric_grid(0, 10, 3), Error);
  EXPECT_THROW(geometric_grid(10, 5, 3), Error);
  EXPECT_THROW(geometric_grid(10, 10, 3), Error);
  EXPECT_THROW(geometric_grid(10, 20, 1), Error);
  EXPECT_THROW(geometric_grid(10, 20, 0), Error);
  EXPECT_THROW(geometric_grid(10, 20, max_grid_sizes + 1), Error);
  EXPECT_THROW(geometric_grid(10, max_size + 1, 3), Error);
}

TEST(ScaledGrid, MultipliesBeforeRounding) {
  EXPECT_EQ(scaled_grid(100, 4, 4), (Sizes{100, 400, 1600, 6400}));
  // 100 / 0.23^j; rounding at each step would give 1891 and 8222.
  EXPECT_EQ(scaled_grid(100, 1 / 0.23, 4), (Sizes{100, 435, 1890, 8219}));
  EXPECT_EQ(scaled_grid(1, 1.1, 8), (Sizes{1, 2}));
  EXPECT_EQ(scaled_grid(3, 2.5, 2), (Sizes{3, 8}));  // 7.5 goes up
}

TEST(ScaledGrid, RefusesWhatIsNoGrid) {
  EXPECT_THROW(scaled_grid(0, 2, 3), Error);
  EXPECT_THROW(scaled_grid(1, 1, 3), Error);
  EXPECT_THROW(scaled_grid(1, 0.5, 3), Error);
  EXPECT_THROW(scaled_grid(1, HUGE_VAL, 3), Error);
  EXPECT_THROW(scaled_grid(1, std::nan(""), 3), Error);
  EXPECT_THROW(scaled_grid(1, 2, 0), Error);
  EXPECT_EQ(scaled_grid(1, 2, 63).back(), max_size);
  EXPECT_THROW(scaled_grid(1, 2, 64), Error);
}

TEST(ReplicateRule, SmallestBoundThatCoversDecides) {
  const ReplicateRule rule{{{10'000, 20'000}, {100'000, 2000}}, 100};
  EXPECT_EQ(rule.count(1), 20'000u);
  EXPECT_EQ(rule.count(10'000), 20'000u);
  EXPECT_EQ(rule.count(10'001), 2000u);
  EXPECT_EQ(rule.count(100'000), 2000u);
  EXPECT_EQ(rule.count(100'001), 100u);
  EXPECT_THROW((ReplicateRule{{{10, 5}}, std::nullopt}.count(11)), Error);
}

}  // namespace
}  // namespace ramify
