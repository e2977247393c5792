// Where cylinders lie: end points to 1e-12 by hand, by other formulas of the sources, and by what must hold.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "support/error_of.hpp"
#include "support/shape_rules.hpp"
#include <gtest/gtest.h>

#include "ramify/shape/degrees.hpp"
#include "ramify/shape/limb_walk.hpp"

namespace ramify {
namespace {

using test::deviation;
using test::extent;
using test::placed;
using test::plane;
using test::tropism;

constexpr double tolerance = 1e-12;

const Tree cherry({2, 0, 0});

/// All external nodes at that many edges from the root, k children a fork.
Tree complete_tree(unsigned levels, std::uint32_t k = 2) {
  std::vector<std::uint32_t> word;
  const std::function<void(unsigned)> add = [&](unsigned below) {
    word.push_back(below > 0 ? k : 0);
    for (std::uint32_t child = 0; below > 0 && child < k; ++child) add(below - 1);
  };
  add(levels);
  return Tree(word);
}

Tree chain_to_the_left(unsigned n) {
  std::vector<std::uint32_t> word(n, 2);
  word.insert(word.end(), n + 1, 0);
  return Tree(word);
}

void expect_point(const Point3& point, const Point3& expected, double within = tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(point[i], expected[i], within) << "coordinate " << i;
}

Point3 difference(const Point3& a, const Point3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double norm(const Point3& a) {
  return std::sqrt(dot(a, a));
}

Point3 heading(const Limb& limb) {
  const Point3 way = difference(limb.end, limb.start);
  return {way[0] / norm(way), way[1] / norm(way), way[2] / norm(way)};
}

double angle_between(const Limb& a, const Limb& b) {
  return degrees(std::acos(std::clamp(dot(heading(a), heading(b)), -1.0, 1.0)));
}

ShapeRules sticks(DeviationRule turning) {
  return {extent("constant", {0.1}), extent("constant", {1}), std::move(turning)};
}

TEST(PlaceLimbs, ACherryByHand) {
  const Shape shape = placed(cherry, sticks(deviation("constant", {30})));
  ASSERT_EQ(shape.limbs.size(), 3u);
  expect_point(shape.limbs[0].start, {0, 0, 0});
  expect_point(shape.limbs[0].end, {0, 1, 0});
  expect_point(shape.limbs[1].end, {-0.5, 1 + std::sqrt(3) / 2, 0});
  expect_point(shape.limbs[2].end, {0.5, 1 + std::sqrt(3) / 2, 0});
}

TEST(PlaceLimbs, ChildrenStartWhereTheirMotherEnds) {
  const Shape shape = placed(complete_tree(3), sticks(deviation("constant", {40})));
  expect_point(shape.limbs[2].start, shape.limbs[1].end);
  expect_point(shape.limbs[9].start, shape.limbs[8].end);
}

// Half a turn of the plane between mother and child exchanges the sides of the next fork.
TEST(PlaceLimbs, ThePlaneRollsAboutTheBranchsOwnAxis) {
  ShapeRules rules = sticks(deviation("constant", {30}));
  rules.plane = plane("carried", {90});
  const Shape shape = placed(complete_tree(2), rules);
  const double c = std::sqrt(3) / 2;
  // The first child heads (-1/2, c, 0), its e is (-c, -1/2, 0); rolled by 90 degrees e becomes n = h x e = z.
  expect_point(shape.limbs[2].end, {-0.5 - 0.5 * c, 1 + c + c * c, 0.5});
  expect_point(shape.limbs[3].end, {-0.5 - 0.5 * c, 1 + c + c * c, -0.5});
}

TEST(PlaceLimbs, LateralsOfATrunkFollowTheDivergence) {
  ShapeRules rules = sticks(deviation("roles", {0, 60}));
  rules.plane = plane("carried", {137.5});
  rules.main = MainChild::first;
  const Shape shape = placed(chain_to_the_left(5), rules);
  // The internal nodes are 0..4, the lateral of node k is 10 - k.
  std::vector<double> azimuths;
  for (std::size_t k = 0; k < 5; ++k) {
    expect_point(heading(shape.limbs[k]), {0, 1, 0});
    const Point3 h = heading(shape.limbs[10 - k]);
    azimuths.push_back(degrees(std::atan2(-h[2], h[0])));
  }
  for (std::size_t k = 1; k < 5; ++k)
    EXPECT_NEAR(std::remainder(azimuths[k] - azimuths[k - 1] - 137.5, 360), 0, 1e-10);
}

TEST(PlaneRule, FractionsOfSchimperAndBraun) {
  const std::array expected{180.0, 120.0, 144.0, 135.0, 138.46153846153845, 137.14285714285714};
  for (unsigned i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(schimper_braun_angle(i + 1), expected[i], tolerance);
  EXPECT_NEAR(schimper_braun_angle(40), 180 * (3 - std::sqrt(5)), 1e-12);  // 137.5078
  EXPECT_NEAR(schimper_braun_angle(40), 137.5078, 5e-5);
}

TEST(ExtentRule, TheRootsRadiusIsThatOfAllItsPipes) {
  // c_R (n+1)^(1/3): of n = 100, 4.6570 (catalogue 0.4).
  ShapeRules rules = sticks(deviation("murray", {}));
  rules.radius = extent("leaves_power", {1, 3});
  EXPECT_NEAR(placed(chain_to_the_left(100), rules).limbs[0].radius, 4.6570, 5e-5);
  EXPECT_NEAR(placed(chain_to_the_left(100), rules).limbs[0].radius, std::cbrt(101), tolerance);
}

TEST(ExtentRule, RadiiObeyTheSumOfPowersAtEveryFork) {
  for (const double exponent : {2.0, 2.49, 3.0}) {
    ShapeRules rules = sticks(deviation("constant", {30}));
    rules.radius = extent("leaves_power", {0.7, exponent});
    const Shape shape = placed(Tree({2, 2, 0, 0, 3, 0, 0, 0}), rules);
    const auto power = [&](std::size_t node) { return std::pow(shape.limbs[node].radius, exponent); };
    EXPECT_NEAR(power(0), power(1) + power(4), tolerance);
    EXPECT_NEAR(power(4), power(5) + power(6) + power(7), tolerance);
    EXPECT_NEAR(shape.limbs[2].radius, 0.7, tolerance);
  }
}

TEST(Murray, TableOfAngles) {
  // E4: the larger sibling of radius 1, the smaller c; the mother (1 + c^x)^(1/x).
  const auto angles = [](double c, double x) {
    const double mother = std::pow(1 + std::pow(c, x), 1 / x);
    return std::array{murray_angle(mother, 1, c), murray_angle(mother, c, 1)};
  };
  const auto expect = [](std::array<double, 2> found, double larger, double smaller) {
    EXPECT_NEAR(found[0], larger, 5e-4);
    EXPECT_NEAR(found[1], smaller, 5e-4);
  };
  expect(angles(0.25, 3), 3.514, 78.679);
  expect(angles(0.5, 3), 13.045, 64.534);
  expect(angles(0.75, 3), 25.506, 49.953);
  expect(angles(1, 3), 37.467, 37.467);
  EXPECT_NEAR(angles(1, 3)[0], degrees(std::acos(std::pow(2, -1.0 / 3))), tolerance);
  expect(angles(1, 2.49), 29.251, 29.251);
  EXPECT_NEAR(angles(0.5, 2)[1], 0, 1e-5);
}

TEST(Murray, AnExponentBelowTwoIsRefused) {
  EXPECT_EQ(
      test::error_of([] { murray_angle(std::pow(2, 1 / 1.5), 1, 1); }),
      "Murray's angle of radii 1 and 1 on 1.5874 (its cosine would be 1.25992: radii must grow by an "
      "exponent of 2 or more): raise the exponent of the radius, or take another rule for the deviation");
  ShapeRules rules = sticks(deviation("murray", {}));
  rules.radius = extent("leaves_power", {1, 1.5});
  EXPECT_NE(test::error_of([&] { placed(cherry, rules); }), "");
  rules.radius = extent("leaves_power", {1, 3});
  EXPECT_NE(test::error_of([&] { placed(Tree({3, 0, 0, 0}), rules); }).find("of two branches"),
            std::string::npos);
}

/// GMT1 as Aono and Kunii print it, z up: the end of child i of the branch from a to b.
Point3 gmt1_end(const Point3& a, const Point3& b, double ratio, double h) {
  const double u = b[0] - a[0], v = b[1] - a[1], w = b[2] - a[2];
  const double t = std::sqrt(u * u + v * v + w * w), s = 1 / std::sqrt(u * u + v * v);
  const double c = std::cos(radians(h)), d = std::sin(radians(h));
  return {b[0] + ratio * (u * c - s * t * v * d), b[1] + ratio * (v * c + s * t * u * d),
          b[2] + ratio * w * c};
}

Point3 with_z_up(const Point3& p) {
  return {p[0], -p[2], p[1]};
}

ShapeRules aono_kunii(double first, double second, std::array<double, 2> angles) {
  ShapeRules rules{extent("ratios", {1, 0.7, 0.7}), extent("ratios", {10, first, second}),
                   deviation("roles", {angles[0], angles[1]})};
  rules.plane = plane("gradient", {0});
  rules.main = MainChild::first;
  return rules;
}

TEST(AonoKunii, Gmt1EndsWhereTheirFormulasSay) {
  const Tree tree = complete_tree(6);
  const Shape shape = placed(tree, aono_kunii(0.9, 0.7, {20, 50}));
  // Of the trunk, where their formula divides by zero, the plane xz (X44).
  const double c = std::cos(radians(20)), s = std::sin(radians(20));
  expect_point(shape.limbs[1].end, {9 * s, 10 + 9 * c, 0});
  const auto check = [&](std::size_t mother, std::size_t child, double ratio, double h) {
    const Limb& m = shape.limbs[mother];
    expect_point(with_z_up(shape.limbs[child].end), gmt1_end(with_z_up(m.start), with_z_up(m.end), ratio, h));
  };
  check(1, 2, 0.9, 20);
  check(1, 33, 0.7, -50);
  check(2, 3, 0.9, 20);
  check(2, 18, 0.7, -50);
  check(64, 65, 0.9, 20);
  check(64, 96, 0.7, -50);
}

TEST(AonoKunii, Gmt2MovesTheEndByFieldAndControllers) {
  ShapeRules rules = aono_kunii(0.9, 0.8, {0, 45});
  const Shape free = placed(cherry, rules);
  rules.tropisms = {tropism("shift", {0.3, -0.3, -0.3}), tropism("controller", {-1.0, 30, 0, 0, 0, 100}),
                    tropism("controller", {5, 1, 1, 1, 2, 3})};  // acts on no branch of level 1
  const Shape moved = placed(cherry, rules);
  for (const std::size_t node : {1u, 2u}) {
    const Point3 end = free.limbs[node].end, way = difference({30, 0, 0}, end);
    expect_point(moved.limbs[node].end, {end[0] + 0.3 - way[0] / norm(way), end[1] - 0.3 - way[1] / norm(way),
                                         end[2] - 0.3 - way[2] / norm(way)});
  }
}

TEST(AonoKunii, Gmt2sRatiosAreOfTheMotherAsSheWasMoved) {
  ShapeRules rules = aono_kunii(0.9, 0.8, {0, 45});
  rules.tropisms = {tropism("shift", {0.3, -0.3, -0.3})};
  const Shape shape = placed(complete_tree(2), rules);
  const auto way = [&](std::size_t node) {
    return difference(shape.limbs[node].end, shape.limbs[node].start);
  };
  const double mother = norm(way(1));
  EXPECT_GT(std::abs(mother - 9), 0.1);
  EXPECT_NEAR(norm(difference(way(2), {0.3, -0.3, -0.3})), 0.9 * mother, tolerance);
  EXPECT_NEAR(norm(difference(way(3), {0.3, -0.3, -0.3})), 0.8 * mother, tolerance);
}

TEST(AonoKunii, Gmt4FallsFromTheHighestAngleToTheLowest) {
  for (const double category : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    ShapeRules rules = aono_kunii(0.9, 0.7, {0, 0});
    rules.deviation = deviation("levels", {category, 0, 90, 20, 9, 0.5});
    const Shape shape = placed(chain_to_the_left(9), rules);
    const auto angle = [&](std::size_t k) { return angle_between(shape.limbs[k], shape.limbs[18 - k]); };
    EXPECT_NEAR(angle(8), 20, 1e-6) << category;                       // the last fork
    EXPECT_NEAR(angle(0), category == 5 ? 20 : 90, 1e-6) << category;  // the first
    // At the middle, tau = 1/2: by the five closed forms.
    const std::array<double, 5> middle{55, 20 + 70 * 0.75, 20 + 70 * 0.25, 55, 90};
    EXPECT_NEAR(angle(4), middle[static_cast<std::size_t>(category) - 1], 1e-6) << category;
  }
}

TEST(Honda, BranchPlanesAreLevelButOnTheTrunk) {
  ShapeRules rules = sticks(deviation("roles", {20, 50}));
  rules.plane = plane("horizontal", {137.5});
  rules.main = MainChild::first;
  const Shape shape = placed(complete_tree(5), rules);
  // Of two children turned by T and S from h, sin(S) h1 + sin(T) h2 is along h, so h1/sin T - h2/sin S less
  // its part along h is the line across the mother.
  const auto rise_of_plane = [&](std::size_t mother, std::size_t first, std::size_t second) {
    const Point3 h = heading(shape.limbs[mother]), a = heading(shape.limbs[first]),
                 b = heading(shape.limbs[second]);
    Point3 across = difference(a, b);
    const double along = dot(across, h);
    for (std::size_t i = 0; i < 3; ++i) across[i] -= along * h[i];
    return across[1] / norm(across);
  };
  EXPECT_NEAR(rise_of_plane(17, 18, 25), 0, tolerance);  // the root's second child
  EXPECT_NEAR(rise_of_plane(18, 19, 22), 0, tolerance);
  EXPECT_GT(std::abs(rise_of_plane(1, 2, 9)), 0.01);  // the trunk goes on in the first
}

TEST(HTree, TipsFillTheirRectangle) {
  ShapeRules rules = sticks(deviation("constant", {90}));
  rules.length = extent("ratios", {1, std::sqrt(0.5), std::sqrt(0.5)});
  const Shape shape = placed(complete_tree(8), rules);
  std::set<std::pair<long, long>> tips;
  for (const Limb& limb : shape.limbs) {
    EXPECT_NEAR(limb.end[2], 0, tolerance);
    tips.emplace(std::lround(limb.end[0] * 1e6), std::lround(limb.end[1] * 1e6));
  }
  EXPECT_EQ(tips.size(), shape.limbs.size());  // no branch ends where another does
}

ShapeRules pythagoras(double first, double second, double flip) {
  ShapeRules rules{extent("legs", {0.5, first, second, flip}), extent("radius_power", {2, 1}),
                   deviation("triangle", {first, second, flip})};
  rules.joint = BranchJoint::legs;
  rules.main = MainChild::first;
  return rules;
}

TEST(Pythagoras, SquaresStandOnTheLegs) {
  const Shape shape = placed(complete_tree(3), pythagoras(30, 60, 0));
  // The unit square's far side is from (-1/2, 1) to (1/2, 1); the right angle lies over it.
  const Point3 corner{-0.5 + std::cos(radians(30)) * std::cos(radians(30)),
                      1 + std::cos(radians(30)) * std::sin(radians(30)), 0};
  expect_point(shape.limbs[1].start, {(corner[0] - 0.5) / 2, (corner[1] + 1) / 2, 0});
  expect_point(shape.limbs[8].start, {(corner[0] + 0.5) / 2, (corner[1] + 1) / 2, 0});
  EXPECT_NEAR(shape.limbs[1].radius, 0.5 * std::cos(radians(30)), tolerance);
  EXPECT_NEAR(shape.limbs[8].radius, 0.5 * std::sin(radians(30)), tolerance);
}

TEST(Pythagoras, EveryLevelHasTheAreaOfTheFirst) {
  const Tree tree = complete_tree(6);
  for (const double flip : {0.0, 1.0}) {
    const Shape shape = placed(tree, pythagoras(35, 55, flip));
    std::vector<double> areas(8, 0);
    const auto levels = depths(tree);
    for (std::size_t node = 0; node < tree.node_count(); ++node)
      areas[levels[node]] += std::pow(2 * shape.limbs[node].radius, 2);
    for (std::size_t level = 1; level <= 7; ++level) EXPECT_NEAR(areas[level], 1, tolerance) << level;
  }
}

TEST(Pythagoras, FlippingExchangesTheAnglesAtEvenDepths) {
  const Shape shape = placed(complete_tree(2), pythagoras(30, 60, 1));
  EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[1]), 30, 1e-10);
  EXPECT_NEAR(angle_between(shape.limbs[1], shape.limbs[2]), 60, 1e-10);
}

/// A branch of radius 1 and length 2 with children of radii 0.6 on the left and 0.4 on the right.
ShapeRules touching() {
  ShapeRules rules{extent("ratios", {1, 0.6, 0.4}), extent("constant", {2}), deviation("roles", {20, 50})};
  rules.joint = BranchJoint::sides;
  rules.main = MainChild::first;
  return rules;
}

TEST(Joint, SidesMeetOnBothSidesOfTheMothersEnd) {
  const Shape shape = placed(cherry, touching());
  const double c = std::cos(radians(20)), s = std::sin(radians(20));
  expect_point(shape.limbs[1].start, {-1 + 0.6 * c, 2 + 0.6 * s, 0});
  expect_point(shape.limbs[1].end, {-1 + 0.6 * c - 2 * s, 2 + 0.6 * s + 2 * c, 0});
  const double wide_c = std::cos(radians(50)), wide_s = std::sin(radians(50));
  expect_point(shape.limbs[2].start, {1 - 0.4 * wide_c, 2 + 0.4 * wide_s, 0});
  expect_point(shape.limbs[2].end, {1 - 0.4 * wide_c + 2 * wide_s, 2 + 0.4 * wide_s + 2 * wide_c, 0});
}

// Whatever has turned a child: the point of the mother's rim is one of its own.
TEST(Joint, RimsTouchAfterATropismToo) {
  ShapeRules rules = touching();
  rules.tropisms = {tropism("torque", {0.3, 0.2, -1, 0.5})};
  const Shape shape = placed(cherry, rules);
  for (const auto& [child, corner] : {std::pair(1, Point3{-1, 2, 0}), std::pair(2, Point3{1, 2, 0})}) {
    const Limb& limb = shape.limbs[static_cast<std::size_t>(child)];
    const Point3 to_corner = difference(corner, limb.start);
    EXPECT_NEAR(norm(to_corner), limb.radius, tolerance);
    EXPECT_NEAR(dot(to_corner, heading(limb)), 0, tolerance);
  }
}

// Of a bridge from 0 to 0 the variance after the part t of a walk is t (1 - t) that of the free walk's end.
TEST(LimbWalk, PlacesHaveTheMeansAndVariancesOfABridge) {
  constexpr std::size_t walks = 20'000, steps = 4;
  const std::vector<Limb> limbs(walks, {{1, 2, 3}, {1, 6, 6}, 1});  // 5 long
  Stream chance({19, 0}, 0, Lane::limb_walk);
  const auto bends = bends_of_walks(limbs, {steps, 0.2}, chance);
  ASSERT_EQ(bends.size(), walks * (steps - 1));
  for (std::size_t step = 1; step < steps; ++step) {
    const double part = static_cast<double>(step) / steps, variance = part * (1 - part);
    const Point3 between{1, 2 + 4 * part, 3 + 3 * part};
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0, squares = 0;
      for (std::size_t walk = 0; walk < walks; ++walk) {
        const double off = bends[walk * (steps - 1) + step - 1][i] - between[i];  // free ends: 0.2 times 5
        sum += off;
        squares += off * off;
      }
      // Five standard errors.
      EXPECT_NEAR(sum / walks, 0, 5 * std::sqrt(variance / walks));
      EXPECT_NEAR(squares / walks, variance, 5 * variance * std::sqrt(2.0 / walks));
    }
  }
}

TEST(LimbWalk, WithoutDeviationItIsTheStraightWay) {
  const std::vector<Limb> limbs{{{0, 0, 0}, {3, 6, 9}, 1}};
  Stream chance({19, 0}, 0, Lane::limb_walk);
  const auto bends = bends_of_walks(limbs, {3, 0}, chance);
  expect_point(bends[0], {1, 2, 3});
  expect_point(bends[1], {2, 4, 6});
}

TEST(Tropism, TorqueTurnsByTheSineOfTheAngle) {
  ShapeRules rules = sticks(deviation("constant", {40}));
  rules.tropisms = {tropism("torque", {0.22, 0, -1, 0})};
  const Shape shape = placed(cherry, rules);
  EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[1]), 40 + degrees(0.22 * std::sin(radians(40))),
              1e-9);
}

TEST(Tropism, TheSunDividesTheAngleToIt) {
  ShapeRules rules = sticks(deviation("constant", {60}));
  rules.tropisms = {tropism("pull", {2, 0.25, 0, 1, 0})};
  const Shape shape = placed(Tree({2, 2, 0, 0, 0}), rules);
  const double share = std::pow(3.0 / 5, 0.25);
  EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[1]), 60 / (1 + 2 * share), 1e-9);
  rules.tropisms = {tropism("bend", {2, 0.25, 0, 1, 0})};
  const Shape bent = placed(Tree({2, 2, 0, 0, 0}), rules);
  EXPECT_NEAR(angle_between(bent.limbs[0], bent.limbs[1]), 60 / (1 + 2 * (1 - share)), 1e-9);
}

TEST(Tropism, LeaningAddsToTheHeading) {
  ShapeRules rules = sticks(deviation("constant", {90}));
  rules.tropisms = {tropism("lean", {0.5, 0, 1, 0})};
  expect_point(heading(placed(cherry, rules).limbs[1]), {-1 / std::sqrt(1.25), 0.5 / std::sqrt(1.25), 0});
}

TEST(DeviationRule, BySizeAndOrderByHand) {
  // The first child has 3 nodes and order 2, the second 5 nodes and order 2; the third level has 1 and 3.
  const Tree tree({2, 2, 0, 0, 2, 2, 0, 0, 0});
  const auto angles = [&](const char* rule, std::vector<double> constants) {
    const Shape shape = placed(tree, sticks(deviation(rule, std::move(constants))));
    return std::array{
        angle_between(shape.limbs[0], shape.limbs[1]), angle_between(shape.limbs[0], shape.limbs[4]),
        angle_between(shape.limbs[4], shape.limbs[5]), angle_between(shape.limbs[4], shape.limbs[8])};
  };
  const auto expect = [](std::array<double, 4> found, std::array<double, 4> expected, const char* rule) {
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << rule << ' ' << i;
  };
  expect(angles("log_nodes", {10, 25, 30}), {25, 10, 10, 25}, "log_nodes");
  expect(angles("nodes_share", {30}), {30 * 5.0 / 8, 30 * 3.0 / 8, 30 * 1.0 / 4, 30 * 3.0 / 4},
         "nodes_share");
  expect(angles("orders", {10, 25, 30}), {30, 30, 10, 25}, "orders");
  expect(angles("viennot", {10, 30, 25}), {25, 25, 10.0 * 1 / (2 - 1), 30.0 * (2 - 1) / (2 - 1)}, "viennot");
  expect(angles("depth", {27}), {9, 9, 27.0 / 4, 27.0 / 4}, "depth");
  const double two = 23 / (std::log(2) + 1), three = 23 / (std::log(3) + 1);
  expect(angles("log_depth", {23}), {two, two, three, three}, "log_depth");
  expect(angles("falling", {5, 110, 20}), {70, 5, 5, 50}, "falling");
}

TEST(DeviationRule, TheFirsMainBranchGoesStraightOnBetweenTheOthers) {
  const Tree tree({3, 0, 2, 2, 0, 0, 0, 0});  // leaves 1, 3, 1
  const double other = 90 * (1 - std::cbrt(1.0 / 5));
  for (const double main : {0.0, 1.0}) {  // the fir, and the maple, whose rule is of all three (X69)
    ShapeRules rules = sticks(deviation("radius_gap", {90, main}));
    rules.radius = extent("leaves_power", {1, 3});
    const Shape shape = placed(tree, rules);
    EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[2]), main * 90 * (1 - std::cbrt(3.0 / 5)), 1e-6);
    EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[1]), other, 1e-9);
    EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[7]), other, 1e-9);
    EXPECT_NEAR(angle_between(shape.limbs[1], shape.limbs[7]), 2 * other, 1e-9);  // in one plane
  }
}

TEST(Arrangement, AWhorlIsSpreadEvenly) {
  for (const std::uint32_t k : {2u, 3u, 5u}) {
    ShapeRules rules = sticks(deviation("constant", {90}));
    rules.arrangement = Arrangement::whorl;
    const Shape shape = placed(complete_tree(1, k), rules);
    for (std::size_t child = 1; child < k; ++child)
      EXPECT_NEAR(angle_between(shape.limbs[child], shape.limbs[child + 1]), 360.0 / k, 1e-9) << k;
  }
}

TEST(Arrangement, AnyNumberOfChildrenShareTheirAngles) {
  ShapeRules rules = sticks(deviation("radius_share", {90}));
  const Shape shape = placed(Tree({4, 0, 0, 0, 1, 0}), rules);
  EXPECT_NEAR(angle_between(shape.limbs[0], shape.limbs[1]), 67.5, 1e-9);
  EXPECT_NEAR(angle_between(shape.limbs[4], shape.limbs[5]), 0, 1e-6);  // one child goes straight on
}

// Azimuths 0, 90 and 200 about a trunk: where each child leans, and its own first child leans in a plane
// turned with it.
TEST(Arrangement, AzimuthsTurnAChildsPlaneToo) {
  ShapeRules rules = sticks(deviation("constant", {30}));
  rules.arrangement = Arrangement::turned;
  rules.azimuths = {0, 90, 200};
  const Shape shape = placed(complete_tree(2, 3), rules);
  const double c = std::cos(radians(30)), s = std::sin(radians(30));
  for (std::size_t child = 0; child < 3; ++child) {
    // e is (-1,0,0) and n = h x e is (0,0,1).
    const double azimuth = radians(rules.azimuths[child]);
    const Point3 lean{-std::cos(azimuth), 0, std::sin(azimuth)};
    expect_point(heading(shape.limbs[1 + 4 * child]), {s * lean[0], c, s * lean[2]});
    // Twice the lean of its mother, on the same side.
    expect_point(heading(shape.limbs[2 + 4 * child]),
                 {std::sin(radians(60)) * lean[0], std::cos(radians(60)), std::sin(radians(60)) * lean[2]});
  }
}

// Along a lateral of a trunk its own laterals stand left and right in turn; coplanar ones all on one side.
TEST(Arrangement, AlternatingExchangesSidesOffTheTrunk) {
  for (const bool alternates : {true, false}) {
    ShapeRules rules = sticks(deviation("roles", {0, 50}));
    rules.main = MainChild::first;
    rules.arrangement = alternates ? Arrangement::alternating : Arrangement::coplanar;
    // The trunk's lateral (node 2) goes on in nodes 3 and 4, whose laterals are 8, 7 and 6.
    const Shape shape = placed(Tree({2, 0, 2, 2, 2, 0, 0, 0, 0}), rules);
    const auto side = [&](std::size_t mother, std::size_t child) {
      const Point3 m = heading(shape.limbs[mother]), l = heading(shape.limbs[child]);
      return m[0] * l[1] - m[1] * l[0] > 0;
    };
    EXPECT_EQ(side(2, 8) != side(3, 7), alternates);
    EXPECT_EQ(side(3, 7) != side(4, 6), alternates);
  }
}

TEST(ExtentRule, ATrunkOfItsOwnLengthChangesNothingAbove) {
  ShapeRules rules = sticks(deviation("constant", {20}));
  rules.length = extent("ratios", {8, 0.5, 0.25, 3});
  rules.main = MainChild::first;
  const Shape shape = placed(complete_tree(2), rules);
  const auto length = [&](std::size_t node) {
    return norm(difference(shape.limbs[node].end, shape.limbs[node].start));
  };
  EXPECT_NEAR(length(0), 24, tolerance);
  EXPECT_NEAR(length(1), 4, tolerance);
  EXPECT_NEAR(length(4), 2, tolerance);
  EXPECT_NEAR(length(2), 2, tolerance);
}

// Both children change sides, or none does (X70): of 2^10 forks about half.
TEST(PlaceLimbs, MirroredForksKeepTheirChildrenApart) {
  ShapeRules rules = sticks(deviation("roles", {10, 30}));
  rules.mirrors = true;
  rules.main = MainChild::first;
  const Tree tree = chain_to_the_left(1000);
  const Shape shape = placed(tree, rules);
  int turned = 0;
  for (std::size_t k = 0; k + 1 < 1000; ++k) {
    EXPECT_NEAR(angle_between(shape.limbs[k + 1], shape.limbs[2000 - k]), 40, 1e-6);
    const Point3 h = heading(shape.limbs[k]), c = heading(shape.limbs[k + 1]);
    turned += h[0] * c[1] - h[1] * c[0] < 0 ? 1 : 0;  // the main child to the right
  }
  EXPECT_NEAR(turned, 500, 5 * std::sqrt(250));
}

TEST(PlaceLimbs, ForeshorteningOnlyTakesAway) {
  ShapeRules rules = sticks(deviation("constant", {30}));
  rules.foreshortens = true;
  const Tree tree = complete_tree(9);
  const Shape shape = placed(tree, rules);
  double sum = 0, largest = 0;
  for (std::size_t node = 0; node + 1 < tree.node_count(); ++node) {
    if (tree.arity(node) == 0) continue;
    const double angle = angle_between(shape.limbs[node], shape.limbs[node + 1]);
    largest = std::max(largest, angle);
    sum += angle;
  }
  EXPECT_LE(largest, 30 + 1e-9);
  // The mean of |cos| is 2/pi, its standard deviation 0.308; 511 forks.
  EXPECT_NEAR(sum / 511 / 30, 2 / std::numbers::pi, 5 * 0.308 / std::sqrt(511));
}

TEST(Lightning, AnglesAndLengthsHaveTheirLaws) {
  ShapeRules rules{extent("ratios", {1, 0.95, 0.5}), extent("uniform", {1, 0.8, 1.2}),
                   deviation("normal", {16, 1})};
  rules.plane = plane("random", {});
  const Tree tree = complete_tree(10);
  const Shape shape = placed(tree, rules);
  double angles = 0, lengths = 0;
  for (std::size_t node = 0; node + 1 < tree.node_count(); ++node) {
    const double length = norm(difference(shape.limbs[node].end, shape.limbs[node].start));
    EXPECT_GE(length, 0.8);
    EXPECT_LE(length, 1.2);
    lengths += length;
    if (tree.arity(node) > 0) angles += angle_between(shape.limbs[node], shape.limbs[node + 1]);
  }
  EXPECT_NEAR(angles / 1023, 16, 5 / std::sqrt(1023));
  EXPECT_NEAR(lengths / 2046, 1, 5 * 0.1155 / std::sqrt(2046));
}

TEST(Lung, TheTrunkHasTheHighestOrdersDiameterAndLength) {
  // X1: D_17 and L_17 are the trunk's, not those of an order below the first.
  ShapeRules rules{extent("order_ratio", {1.61 / 2, 1.40}), extent("order_ratio", {5.0, 1.49}),
                   deviation("constant", {30})};
  const Shape shape = placed(complete_tree(4), rules);
  EXPECT_NEAR(shape.limbs[0].radius, 0.805, tolerance);
  expect_point(shape.limbs[0].end, {0, 5, 0});
  EXPECT_NEAR(shape.limbs[1].radius, 0.805 / 1.40, tolerance);
  EXPECT_NEAR(norm(difference(shape.limbs[2].end, shape.limbs[2].start)), 5 / (1.49 * 1.49), tolerance);
}

TEST(PlaceLimbs, AChainOfAHundredThousandIsNoRecursion) {
  const Shape shape = placed(chain_to_the_left(100'000), sticks(deviation("constant", {0})));
  EXPECT_NEAR(shape.limbs[99'999].end[1], 100'000, 1e-6);
}

TEST(PlaceLimbs, NumbersThatAreNoneAreRefused) {
  ShapeRules rules = sticks(deviation("constant", {10}));
  rules.length = extent("radius_power", {1e300, 10});
  rules.radius = extent("constant", {1e300});
  EXPECT_EQ(
      test::error_of([&] { placed(cherry, rules); }),
      "the length of node 1 is inf (it must be a number and not negative): change the constants of its rule");
  rules = sticks([](const ForkQuestion&, std::size_t) { return std::nan(""); });
  EXPECT_NE(test::error_of([&] { placed(cherry, rules); }).find("the deviation of node 2 is nan"),
            std::string::npos);
  rules = sticks(deviation("constant", {10}));
  rules.radius = [](const ExtentQuestion&) { return -1.0; };
  EXPECT_NE(test::error_of([&] { placed(cherry, rules); }).find("the radius of node 1 is -1"),
            std::string::npos);
}

}  // namespace
}  // namespace ramify
