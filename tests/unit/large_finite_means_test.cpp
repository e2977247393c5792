// Means at sizes that were not given, between those that were.
#include <cmath>

#include <gtest/gtest.h>

#include "ramify/large/finite_means.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

TEST(FiniteMeans, AreKnownBetweenTheGivenSizes) {
  const Model bst = Model::parse("bst");
  const FiniteMeans means(bst, {100, 1'000'000});
  const ExactMeans exact(bst, 1000);
  EXPECT_EQ(means.moments(statistic::strahler, 1000)->mean, exact.moments(statistic::strahler, 1000)->mean);
  const FiniteMeans asked(bst, {100'000, 1'000'000});
  EXPECT_EQ(means.moments(statistic::strahler, 100'000)->mean,
            asked.moments(statistic::strahler, 100'000)->mean);
  // Streams of order 1 of a BST: (n + 1)/3.
  EXPECT_NEAR(means.moments({statistic::streams, {1}}, 50'000)->mean, 50'001 / 3.0, 1e-6);
  EXPECT_FALSE(means.moments(statistic::strahler, 1'000'001));
  // The variances of counts cost the most, and are computed as far as a given size asks for them.
  EXPECT_FALSE(std::isnan(means.moments({statistic::streams, {1}}, 100)->variance));
  EXPECT_TRUE(std::isnan(means.moments({statistic::streams, {1}}, 101)->variance));
}

TEST(FiniteMeans, WithoutLawsOnAGridEndWithTheExactOnes) {
  const Model split = Model::parse("split(0.25)");
  const Size limit = law_limit(split);
  const FiniteMeans means(split, {10, 10 * limit});
  EXPECT_TRUE(means.moments(statistic::height, 10));
  EXPECT_FALSE(means.moments(statistic::height, limit + 1));
}

}  // namespace
}  // namespace ramify
