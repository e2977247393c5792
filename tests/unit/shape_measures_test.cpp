// Volume, height, spread and extents of every order (B24), by hand.
#include "ramify/shape/shape_measures.hpp"

#include <cmath>
#include <numbers>

#include "support/shape_rules.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr double pi = std::numbers::pi;

TEST(ShapeMeasures, OfAFormByHand) {
  // A trunk of order 3 over two forks of order 2, turned by 60 degrees; leaves do not count.
  const Tree tree({2, 2, 0, 0, 2, 0, 0});
  const ShapeRules rules{test::extent("order_power", {0.1, 1}), test::extent("order_ratio", {4, 2}),
                         test::deviation("constant", {60})};
  const ShapeMeasures measures = measure_shape(tree, test::placed(tree, rules));
  EXPECT_NEAR(measures.length, 4 + 2 + 2, 1e-12);
  EXPECT_NEAR(measures.volume, pi * (0.09 * 4 + 2 * 0.04 * 2), 1e-12);
  EXPECT_NEAR(measures.surface, 2 * pi * (0.3 * 4 + 2 * 0.2 * 2), 1e-12);
  EXPECT_NEAR(measures.height, 4 + 2 * 0.5, 1e-12);
  EXPECT_NEAR(measures.spread, 2 * std::sqrt(3) / 2, 1e-12);
  ASSERT_EQ(measures.orders.size(), 2u);
  EXPECT_EQ(measures.orders[0].order, 2u);
  EXPECT_EQ(measures.orders[0].streams, 2);
  EXPECT_NEAR(measures.orders[0].mean_radius, 0.2, 1e-12);
  EXPECT_NEAR(measures.orders[1].mean_length, 4, 1e-12);
}

TEST(ShapeMeasures, AStreamIsAllCylindersOfItsChain) {
  // A caterpillar: five cylinders of order 2, one stream.
  std::vector<std::uint32_t> word(5, 2);
  word.insert(word.end(), 6, 0);
  const Tree tree(word);
  const ShapeRules rules{test::extent("constant", {1}), test::extent("constant", {3}),
                         test::deviation("constant", {0})};
  const ShapeMeasures measures = measure_shape(tree, test::placed(tree, rules));
  ASSERT_EQ(measures.orders.size(), 1u);
  EXPECT_EQ(measures.orders[0].cylinders, 5);
  EXPECT_EQ(measures.orders[0].streams, 1);
  EXPECT_NEAR(measures.orders[0].mean_length, 3, 1e-12);
  EXPECT_NEAR(measures.orders[0].mean_stream_length, 15, 1e-12);
}

}  // namespace
}  // namespace ramify
