#include <cmath>
#include <vector>

#include "support/definitions.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/statistic/horton_law.hpp"
#include "ramify/statistic/order_ratios.hpp"

namespace ramify {
namespace {

using Counts = std::vector<std::uint64_t>;

// Kruszewski 1996, Fig 3.1: (23/15 + 15/5 + 5/2) / 3.
TEST(OrderRatios, OfFigure31) {
  const OrderRatios ratios = order_ratios(Counts{23, 15, 5, 2});
  EXPECT_NEAR(ratios.mean_ratio, 2.344444444444444, 1e-14);
  EXPECT_NEAR(ratios.geometric, std::cbrt(23.0 / 2), 1e-14);
  // Least squares by hand: slope = (-3 log 23 - log 15 + log 5 + 3 log 2) / 10.
  const double slope = (-3 * std::log(23.0) - std::log(15.0) + std::log(5.0) + 3 * std::log(2.0)) / 10;
  EXPECT_NEAR(ratios.regression, std::exp(-slope), 1e-13);
}

TEST(OrderRatios, AreAllTheRatioOfAGeometricSequence) {
  for (const std::uint64_t r : {2u, 3u, 7u}) {
    const OrderRatios ratios = order_ratios(Counts{r * r * r * r, r * r * r, r * r, r, 1});
    const double exact = static_cast<double>(r);
    EXPECT_NEAR(ratios.mean_ratio, exact, 1e-13);
    EXPECT_NEAR(ratios.regression, exact, 1e-13);
    EXPECT_NEAR(ratios.geometric, exact, 1e-13);
  }
}

TEST(OrderRatios, OfTwoOrdersAreTheOneRatio) {
  const OrderRatios ratios = order_ratios(Counts{11, 10});
  EXPECT_NEAR(ratios.mean_ratio, 1.1, 1e-15);
  EXPECT_NEAR(ratios.regression, 1.1, 1e-14);
  EXPECT_NEAR(ratios.geometric, 1.1, 1e-15);
}

TEST(OrderRatios, DoNotExistWithoutASecondOrder) {
  for (const Counts& counts : {Counts{1}, Counts{}}) {
    const OrderRatios ratios = order_ratios(counts);
    EXPECT_TRUE(std::isnan(ratios.mean_ratio));
    EXPECT_TRUE(std::isnan(ratios.regression));
    EXPECT_TRUE(std::isnan(ratios.geometric));
  }
}

TEST(OrderRatios, OfTheAppleDifferForNodesAndStreams) {
  // split(1/4.35), n = 579 (A6, C11).
  const OrderRatios nodes = order_ratios(Counts{580, 394, 140, 35, 8, 2});
  const OrderRatios streams = order_ratios(Counts{580, 186, 46, 11, 3, 1});
  EXPECT_NEAR(nodes.mean_ratio, 3.332, 0.0005);
  EXPECT_NEAR(streams.mean_ratio, 3.602, 0.0005);
  EXPECT_NEAR(streams.regression, 3.683, 0.0005);
}

// B12, H5: the apple of R = 4.35 and order 5 has 464.6 branches (464.7 in H5); with 579 the order is 5.15.
TEST(HortonLaw, TurnsOrderIntoSizeAndBack) {
  EXPECT_NEAR(horton_size(4.35, 5), 464.646, 0.001);
  EXPECT_NEAR(horton_order(4.35, 579), 5.15, 0.005);
  for (const double ratio : {0.9, 1.0, 1.0 + 1e-9, 2.0, 4.35})
    for (const double order : {1.0, 3.0, 7.5})
      EXPECT_NEAR(horton_order(ratio, horton_size(ratio, order)), order, 1e-12 * order);
  EXPECT_EQ(horton_size(2, 10), 1023);  // complete
  EXPECT_TRUE(std::isnan(horton_order(0.5, 3)));
  EXPECT_TRUE(std::isnan(horton_size(0, 3)));
}

TEST(OrderRatios, AreTheDefinitionOnEveryTreeToSevenNodes) {
  for (std::size_t n = 1; n <= 7; ++n) {
    for (const auto& shape : test::all_shapes(n)) {
      const auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
      EXPECT_NEAR(order_ratios(nodes).mean_ratio, test::mean_ratio(nodes), 1e-14);
      EXPECT_NEAR(order_ratios(streams).mean_ratio, test::mean_ratio(streams), 1e-14);
    }
  }
}

}  // namespace
}  // namespace ramify
