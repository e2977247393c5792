// Forms that nobody has named rules for: the thesis's own, and that of a measured tree.
#include <cmath>
#include <limits>

#include "support/error_of.hpp"
#include "support/shape_rules.hpp"
#include <gtest/gtest.h>

#include "ramify/shape/usual_rules.hpp"

namespace ramify {
namespace {

const Tree small_tree({2, 2, 0, 0, 0});

double length_of_limb(const Shape& shape, std::size_t node) {
  const auto& [start, end, radius] = shape.limbs[node];
  return std::hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
}

TEST(ThesisRules, RadiusByLeavesAndTenTimesAsLong) {
  const Shape shape = test::placed(small_tree, thesis_rules(small_tree));
  EXPECT_NEAR(shape.limbs[0].radius, std::cbrt(3), 1e-12);
  EXPECT_NEAR(length_of_limb(shape, 1), 10 * std::cbrt(2), 1e-12);
  const Tree wide({3, 0, 0, 0});  // Murray has no angle for three
  EXPECT_EQ(test::placed(wide, thesis_rules(wide)).limbs.size(), 4u);
}

RecordedTree measured(std::vector<double> lengths, std::vector<double> radii) {
  return {"small", small_tree, std::move(lengths), std::move(radii), {}};
}

TEST(MeasuredRules, LengthsAndRadiiAreTheTreesOwn) {
  const RecordedTree tree = measured({5, 4, 3, 2, 1}, {0.9, 0.8, 0.7, 0.6, 0.5});
  const Shape shape = test::placed(tree.tree, measured_rules(tree));
  for (std::size_t node = 0; node < 5; ++node) {
    EXPECT_NEAR(length_of_limb(shape, node), 5.0 - static_cast<double>(node), 1e-12);
    EXPECT_NEAR(shape.limbs[node].radius, 0.9 - 0.1 * static_cast<double>(node), 1e-12);
  }
}

TEST(MeasuredRules, WhatIsNotMeasuredFollowsAConvention) {
  const RecordedTree none = measured({}, {});
  const Shape shape = test::placed(none.tree, measured_rules(none));
  EXPECT_NEAR(length_of_limb(shape, 2), 1, 1e-12);
  EXPECT_NEAR(shape.limbs[0].radius, 3.0 / 40, 1e-12);  // the longest path is 3
  EXPECT_NEAR(std::pow(shape.limbs[0].radius, 2),
              std::pow(shape.limbs[1].radius, 2) + std::pow(shape.limbs[4].radius, 2), 1e-12);
  const RecordedTree unknown_root = measured({std::nan(""), 1, 1, 1, 1}, {});
  EXPECT_NEAR(length_of_limb(test::placed(unknown_root.tree, measured_rules(unknown_root)), 0), 0, 1e-12);
}

RecordedTree with_places() {
  RecordedTree tree = measured({}, {5, 4, 3, 2, 1});
  tree.places = {{1, 2, 3}, {1, 2, 8}, {4, 2, 8}, {-1, 0, 9}, {0, 0, 5}};
  return tree;
}

TEST(MeasuredShape, LimbsGoFromPlaceToPlace) {
  const Shape shape = measured_shape(with_places(), Upwards::y);
  EXPECT_EQ(shape.limbs[0].start, shape.limbs[0].end);
  EXPECT_EQ(shape.limbs[3].start, (Point3{1, 2, 8}));  // its parent is the second node
  EXPECT_EQ(shape.limbs[3].end, (Point3{-1, 0, 9}));
  EXPECT_EQ(shape.limbs[4].start, (Point3{1, 2, 3}));
  EXPECT_EQ(shape.limbs[3].radius, 2);
}

TEST(MeasuredShape, WhatPointsUpInTheFileDoesInThePicture) {
  const Shape shape = measured_shape(with_places(), Upwards::z);
  EXPECT_EQ(shape.limbs[3].end, (Point3{-1, 9, 0}));  // seen from the front: x to the right, y away
  EXPECT_EQ(shape.limbs[1].end, (Point3{1, 8, -2}));
}

TEST(MeasuredShape, ARadiusThatIsNoneIsRefused) {
  RecordedTree tree = with_places();
  tree.radii[2] = std::nan("");
  EXPECT_NE(test::error_of([&] { measured_shape(tree, Upwards::y); }).find("node 3 has the radius"),
            std::string::npos);
}

TEST(MeasuredRules, WhatIsNoNumberIsRefused) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double value : {std::nan(""), -1.0, infinite}) {
    const RecordedTree lengths = measured({1, value, 1, 1, 1}, {}), radii = measured({}, {1, 1, value, 1, 1});
    EXPECT_NE(test::error_of([&] { measured_rules(lengths); }).find("node 2 has the length"),
              std::string::npos);
    EXPECT_NE(test::error_of([&] { measured_rules(radii); }).find("node 3 has the radius"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace ramify
