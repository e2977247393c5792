#include <cmath>

#include <gtest/gtest.h>

#include "ramify/statistic/murray_exponent.hpp"
#include "ramify/statistic/stream_geometry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

const double none = std::nan("");

TEST(StreamGeometry, IsThatOfStreamsAndNotOfNodes) {
  // ((E(EE))E): preorder lengths; the order-1 stream is three nodes long, the others one.
  const Tree tree = from_parentheses("((E(EE))E)");
  const std::vector<double> lengths{3, 2, 10, 1, 20, 30, 40}, radii{1, 4, 2, 7, 2, 2, 6};
  const StreamGeometry geometry = stream_geometry(tree, lengths, radii);
  EXPECT_EQ(geometry.mean_lengths, (std::vector<double>{25, 6}));
  EXPECT_EQ(geometry.mean_radii, (std::vector<double>{3, (3 * 1 + 2 * 4 + 1 * 7) / 6.0}));
}

TEST(StreamGeometry, ForksOfThreeFollowTheRuleOfOrders) {
  // Two of the three have order 1: the fork begins a stream of order 2, and all three end.
  const Tree two = from_parentheses("((EE)(EE)E)");
  EXPECT_EQ(stream_geometry(two, std::vector<double>(8, 1), {}).mean_lengths, (std::vector<double>{1, 1, 1}));
  // One alone has order 1: it goes on.
  const Tree one = from_parentheses("(E(EE)E)");
  EXPECT_EQ(stream_geometry(one, std::vector<double>(6, 1), {}).mean_lengths, (std::vector<double>{1, 2}));
}

TEST(StreamGeometry, LeavesOutWhatIsNotKnown) {
  const Tree tree = from_parentheses("((EE)E)");
  const StreamGeometry geometry =
      stream_geometry(tree, std::vector{none, 5.0, 1.0, none, 3.0}, std::vector{2.0, 4.0, none, none, none});
  EXPECT_EQ(geometry.mean_lengths, (std::vector<double>{2, 5}));
  EXPECT_TRUE(std::isnan(geometry.mean_radii[0]));
  EXPECT_EQ(geometry.mean_radii[1], 4);  // weighted by the one length that is known
  EXPECT_EQ(stream_geometry(tree, {}, std::vector{2.0, 4.0, 1.0, 1.0, 1.0}).mean_radii[1], 3);
  EXPECT_TRUE(stream_geometry(tree, {}, {}).mean_lengths.empty());
}

TEST(MeanRatios, OfAGeometricSequenceAreItsRatio) {
  const MeanRatios ratios = mean_ratios(std::vector<double>{2, 6, 18, 54});
  EXPECT_NEAR(ratios.mean_ratio, 3, 1e-12);
  EXPECT_NEAR(ratios.regression, 3, 1e-12);
  EXPECT_NEAR(ratios.geometric, 3, 1e-12);
  const MeanRatios gap = mean_ratios(std::vector<double>{2, none, 18, 54});
  EXPECT_NEAR(gap.regression, 3, 1e-12);
  EXPECT_NEAR(gap.geometric, 3, 1e-12);
  EXPECT_TRUE(std::isnan(mean_ratios(std::vector<double>{2, none}).regression));
}

TEST(MurrayExponent, SolvesEveryForkAndTakesTheMedian) {
  const double cube_root = std::cbrt(2.0);
  const Tree fork = from_parentheses("(EE)");
  const MurrayExponent three = murray_exponent(fork, std::vector<double>{cube_root, 1, 1});
  EXPECT_NEAR(three.median, 3, 1e-12);
  EXPECT_EQ(three.forks, 1u);
  EXPECT_NEAR(murray_exponent(fork, std::vector<double>{5, 3, 4}).median, 2, 1e-12);
  EXPECT_NEAR(murray_exponent(from_parentheses("(EEE)"), std::vector<double>{6, 3, 4, 5}).median, 3, 1e-12);
}

TEST(MurrayExponent, CountsForksWithoutAnExponentAsInfinite) {
  const Tree tree = from_parentheses("((EE)E)");
  const MurrayExponent half = murray_exponent(tree, std::vector<double>{5, 4, 3, 4, 3});
  EXPECT_EQ(half.forks, 2u);
  EXPECT_EQ(half.infinite, 1u);
  EXPECT_TRUE(std::isnan(half.median));
  EXPECT_EQ(murray_exponent(tree, std::vector<double>{5, 4, none, 1, 3}).forks, 1u);
  EXPECT_TRUE(std::isnan(murray_exponent(tree, {}).median));
  EXPECT_EQ(murray_exponent(from_parentheses("(E)"), std::vector<double>{2, 1}).forks, 0u);
}

}  // namespace
}  // namespace ramify
