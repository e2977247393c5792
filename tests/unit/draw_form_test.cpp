// Forms on a page: projections, outlines and their order, by hand; no pixels.
#include <algorithm>
#include <cmath>
#include <set>

#include "support/error_of.hpp"
#include "support/shape_rules.hpp"
#include <gtest/gtest.h>

#include "ramify/draw/fork_outline.hpp"
#include "ramify/draw/sheet.hpp"

namespace ramify {
namespace {

using Bounds = std::array<double, 4>;  // left, top, right, bottom

Bounds bounds_of(const Patches& patches, std::size_t patch) {
  Bounds bounds{1e9, 1e9, -1e9, -1e9};
  for (const PagePoint point : patches.points(patch)) {
    bounds[0] = std::min(bounds[0], point.x);
    bounds[1] = std::min(bounds[1], point.y);
    bounds[2] = std::max(bounds[2], point.x);
    bounds[3] = std::max(bounds[3], point.y);
  }
  return bounds;
}

void expect_at(PagePoint point, double x, double y) {
  EXPECT_NEAR(point.x, x, 1e-12);
  EXPECT_NEAR(point.y, y, 1e-12);
}

TEST(View, NamedViewsLookFromTheirSide) {
  const Point3 point{1, 2, 3};
  const auto seen = [&](const char* name) {
    const View view = parse_view(name);
    return std::array{view.across(point), view.upward(point), view.nearness(point)};
  };
  const auto expect = [&](const char* name, std::array<double, 3> expected) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(seen(name)[i], expected[i], 1e-12) << name << i;
  };
  expect("front", {1, 2, 3});
  expect("right", {-3, 2, 1});
  expect("back", {-1, 2, -3});
  expect("left", {3, 2, -1});
  expect("top", {1, -3, 2});
  expect("bottom", {1, 3, -2});
  const auto oblique = seen("oblique");  // a rotation keeps lengths
  EXPECT_NEAR(std::hypot(oblique[0], oblique[1], oblique[2]), std::sqrt(14), 1e-12);
  EXPECT_NE(test::error_of([] { parse_view("frnt"); }).find("did you mean front"), std::string::npos);
}

TEST(ForkOutline, ABarIsATaperedRectangle) {
  Patches patches;
  add_bar(patches, {0, 0, 0}, {{10, 20}, {10, 0}, 3, 2});
  const auto points = patches.points(0);
  ASSERT_EQ(points.size(), 4u);
  expect_at(points[0], 7, 20);
  expect_at(points[1], 8, 0);
  expect_at(points[2], 12, 0);
  expect_at(points[3], 13, 20);
}

TEST(ForkOutline, ARibbonIsABarThatBends) {
  Patches patches;
  const std::array<PagePoint, 3> line{{{10, 40}, {10, 20}, {30, 20}}};
  add_ribbon(patches, {0, 0, 0}, line, 3, 1);
  const auto points = patches.points(0);
  ASSERT_EQ(points.size(), 6u);
  const double half = 2 / std::sqrt(2);  // at the corner it is 2 broad to either side of the way between
  expect_at(points[0], 7, 40);
  expect_at(points[1], 10 - half, 20 - half);
  expect_at(points[2], 30, 19);
  expect_at(points[3], 30, 21);
  expect_at(points[4], 10 + half, 20 + half);
  expect_at(points[5], 13, 40);
}

TEST(ForkOutline, ANotchedBarGoesFromCornerToCornerOfTheEnds) {
  // The first child turns to the left about the left corner of the end, by the angle whose tangent is 3/4.
  const PageLimb limb{{0, 100}, {0, 0}, 10, 10};
  const std::array<PageLimb, 1> child{{{{-2, -6}, {-62, -86}, 10, 10}}};
  Patches patches;
  add_notched_bar(patches, {0, 0, 0}, limb, child);
  const auto points = patches.points(0);
  ASSERT_EQ(points.size(), 6u);
  expect_at(points[0], -10, 100);
  expect_at(points[1], -10, 0);
  // The child's own corners are (-10, 0) and (6, -12): the second makes the notch's triangle with the end's
  // two. The outline goes on by a quarter of a radius under the child.
  expect_at(points[2], -11.5, -2);
  expect_at(points[3], 4.5, -14);
  expect_at(points[4], 10, 0);
  expect_at(points[5], 10, 100);
}

TEST(ForkOutline, SidesRunIntoTheBudsOfChildren) {
  // Straight up, two children at right angles.
  const PageLimb limb{{0, 100}, {0, 0}, 10, 8};
  const std::array<PageLimb, 2> children{{{{0, 0}, {-100, 0}, 5, 4}, {{0, 0}, {100, 0}, 5, 4}}};
  Patches patches;
  add_fork(patches, {0, 0, 0}, limb, limb.start, children);
  const auto points = patches.points(0);
  const auto steps = patches.steps(0);
  using enum Patches::Step;
  const std::vector<Patches::Step> expected{move,  line, curve, line, line,  line,
                                            curve, line, line,  line, curve, line};
  EXPECT_TRUE(std::ranges::equal(steps, expected));
  expect_at(points[0], -10, 100);  // left foot
  expect_at(points[1], -8, 12);    // the neck, 1.5 radii below the end
  expect_at(points[2], -8, 0);     // its handle goes on up
  expect_at(points[4], -15, 5);    // the lower side of the left bud, three radii out
  expect_at(points[5], -30, 5);    // its end, 0.3 of the branch out
  expect_at(points[6], -30, -5);
  expect_at(points[7], -15, -5);   // back to the crotch
  expect_at(points[10], 15, -5);   // and over it to the right bud
  expect_at(points[17], 10, 100);  // right foot
  expect_at(bud_end(children[1]), 30, 0);
}

TEST(ForkOutline, AnOutlineIsSymmetricWhereItsForkIs) {
  const PageLimb limb{{0, 100}, {0, 0}, 10, 8};
  const std::array<PageLimb, 2> children{{{{0, 0}, {-30, -40}, 5, 4}, {{0, 0}, {30, -40}, 5, 4}}};
  Patches patches;
  add_fork(patches, {0, 0, 0}, limb, limb.start, children);
  const auto points = patches.points(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PagePoint other = points[points.size() - 1 - i];
    expect_at(points[i], -other.x, other.y);
  }
}

TEST(LeafOutline, EveryApexAndBaseIsAnOutlineOfItsOwn) {
  std::set<std::vector<double>> outlines;
  for (int apex = 0; apex < 9; ++apex)
    for (int base = 0; base < 4; ++base) {
      Patches patches;
      add_leaf(patches, {static_cast<LeafForm::Apex>(apex), static_cast<LeafForm::Base>(base), 0.5},
               {0, 1, 0}, {0, 0}, {0, -10});
      std::vector<double> numbers;
      for (const PagePoint p : patches.points(0)) numbers.insert(numbers.end(), {p.x, p.y});
      const Bounds bounds = bounds_of(patches, 0);
      EXPECT_NEAR(bounds[0], -2.5, 1e-12);  // half the width on either side
      EXPECT_NEAR(bounds[2], 2.5, 1e-12);
      expect_at(patches.points(0).back(), 0, 0);  // closed at the foot
      outlines.insert(numbers);
    }
  EXPECT_EQ(outlines.size(), 36u);
  EXPECT_NE(test::error_of([] { parse_apex("acut"); }).find("did you mean acute"), std::string::npos);
  EXPECT_EQ(parse_apex("emarginate"), LeafForm::Apex::emarginate);
  EXPECT_EQ(parse_base("cordate"), LeafForm::Base::cordate);
}

TEST(LeafOutline, AnOakLeafHasLobesAndSinuses) {
  LeafForm form;
  form.margin = parse_margin("lobed");
  Patches patches;
  add_leaf(patches, form, {0, 1, 0}, {0, 0}, {0, -10});
  const Bounds bounds = bounds_of(patches, 0);
  EXPECT_NEAR(bounds[0], -2.5, 1e-12);
  EXPECT_NEAR(bounds[1], -10, 1e-12);
  EXPECT_NEAR(bounds[2], 2.5, 1e-12);
  EXPECT_NEAR(bounds[3], 0, 1e-12);
  const auto points = patches.points(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PagePoint other = points[points.size() - 1 - i];
    expect_at(points[i], -other.x, other.y);
  }
  // Where curves meet on the left half, the breadth turns twice at every lobe of a side, and at that of the
  // tip.
  std::vector<double> breadths;
  for (std::size_t i = 0; points[i].y > -10 || i == 0; i += 3) breadths.push_back(-points[i].x);
  std::size_t turns = 1;  // the tip's own
  for (std::size_t i = 1; i + 1 < breadths.size(); ++i)
    turns += (breadths[i] - breadths[i - 1]) * (breadths[i + 1] - breadths[i]) < 0;
  EXPECT_EQ(turns, 2u * 3 + 1);
}

ShapeRules sticks() {
  return {test::extent("constant", {0.1}), test::extent("constant", {1}), test::deviation("constant", {60})};
}

Drawing drawn(const Tree& tree, const ShapeRules& rules, const TreeLook& look) {
  Drawing drawing{100, 100, {}, {}};
  add_tree(drawing, {0, 0, 100, 100}, tree, test::placed(tree, rules), look, Cancellation());
  return drawing;
}

const Tree four_leaves({2, 2, 0, 0, 2, 0, 0});

TEST(TreePicture, FillsItsBox) {
  TreeLook look;
  look.style = TreeLook::Style::bars;
  const Drawing drawing = drawn(four_leaves, sticks(), look);
  ASSERT_EQ(drawing.patches.count(), 3u);
  Bounds all{1e9, 1e9, -1e9, -1e9};
  for (std::size_t patch = 0; patch < 3; ++patch) {
    const Bounds one = bounds_of(drawing.patches, patch);
    all = {std::min(all[0], one[0]), std::min(all[1], one[1]), std::max(all[2], one[2]),
           std::max(all[3], one[3])};
  }
  // Wider (2 sin 60 + 0.2) than high (1 + cos 60 + 0.2): the width decides.
  EXPECT_NEAR(all[0] + all[2], 100, 1e-9);
  EXPECT_GT(all[2] - all[0], 90);
  EXPECT_LE(all[2] - all[0], 100 + 1e-9);
}

TEST(TreePicture, BarsThatTouchAlongTheirSidesHaveNoNotch) {
  ShapeRules rules = sticks();
  rules.joint = BranchJoint::sides;
  TreeLook look;
  look.style = TreeLook::Style::bars;
  EXPECT_EQ(drawn(four_leaves, rules, look).patches.points(0).size(), 4u);
  look.fills_notches = true;
  const Drawing drawing = drawn(four_leaves, rules, look);
  const auto trunk = drawing.patches.points(0), left = drawing.patches.points(1);
  ASSERT_EQ(trunk.size(), 8u);               // two children
  EXPECT_EQ(left.size(), 4u);                // none but leaves
  EXPECT_NEAR(trunk[1].x, left[0].x, 1e-6);  // radii of ends are floats
  EXPECT_NEAR(trunk[1].y, left[0].y, 1e-6);
}

TEST(TreePicture, LinesGoWhereTheFormDoes) {
  TreeLook look;
  look.style = TreeLook::Style::lines;
  const Drawing drawing = drawn(four_leaves, sticks(), look);
  ASSERT_EQ(drawing.strokes.size(), 1u);
  ASSERT_EQ(drawing.strokes[0].lines.size(), 3u);
  const double scale = 100 / std::sqrt(3);  // the form is 2 sin 60 wide
  expect_at(drawing.strokes[0].lines[0].from, 50, 50 + scale * 0.75);
  expect_at(drawing.strokes[0].lines[0].to, 50, 50 - scale * 0.25);
  expect_at(drawing.strokes[0].lines[1].to, 0, 50 - scale * 0.75);
}

TEST(TreePicture, BranchesThatBendGoFromPlaceToPlace) {
  Shape shape = test::placed(four_leaves, sticks());
  for (const Limb& limb : shape.limbs) {
    const Point3 beside{limb.start[0] + 0.2, (limb.start[1] + limb.end[1]) / 2, 0};
    shape.bends.push_back(beside);
  }
  const auto picture = [&](TreeLook::Style style) {
    TreeLook look;
    look.style = style;
    look.has_shadow = true;
    Drawing drawing{100, 100, {}, {}};
    add_tree(drawing, {0, 0, 100, 100}, four_leaves, shape, look, Cancellation());
    return drawing;
  };
  const Drawing lines = picture(TreeLook::Style::lines);
  ASSERT_EQ(lines.strokes[0].lines.size(), 6u);
  expect_at(lines.strokes[0].lines[1].from, lines.strokes[0].lines[0].to.x, lines.strokes[0].lines[0].to.y);
  const Drawing ribbons = picture(TreeLook::Style::branches);
  EXPECT_EQ(ribbons.patches.count(), 3u + 3 + 2);  // shadows, branches, and joints of all but the trunk
  EXPECT_EQ(ribbons.patches.points(0).size(), 6u);
  EXPECT_EQ(ribbons.patches.points(3).size(), 6u);
}

TEST(TreePicture, WhatIsNearerLiesOverWhatIsFarther) {
  // A quarter of a turn puts the second forks before and behind the picture.
  ShapeRules rules = sticks();
  rules.plane = test::plane("carried", {90});
  const Tree tree({2, 2, 2, 0, 0, 2, 0, 0, 0});
  TreeLook look;
  look.style = TreeLook::Style::bars;
  const Shape shape = test::placed(tree, rules);
  const auto order = [&](const char* view) {
    look.view = parse_view(view);
    Drawing drawing{100, 100, {}, {}};
    add_tree(drawing, {0, 0, 100, 100}, tree, shape, look, Cancellation());
    std::vector<double> shades;  // paler is farther: red grows with the distance
    for (std::size_t patch = 0; patch < drawing.patches.count(); ++patch)
      shades.push_back(drawing.patches.color(patch)[0]);
    return shades;
  };
  for (const char* view : {"front", "back", "left", "oblique"}) {
    const auto shades = order(view);
    ASSERT_EQ(shades.size(), 4u);
    EXPECT_TRUE(std::ranges::is_sorted(shades, std::greater<>())) << view;
    EXPECT_LT(shades.back(), shades.front()) << view;
  }
}

TEST(TreePicture, LeavesBlossomsAndFruit) {
  TreeLook look;
  EXPECT_EQ(drawn(four_leaves, sticks(), look).patches.count(), 3u);
  look.leaves = LeafLook();
  EXPECT_EQ(drawn(four_leaves, sticks(), look).patches.count(), 3u + 4);
  look.has_fruit = true;  // both forks bear two leaves each: fruit in their place
  EXPECT_EQ(drawn(four_leaves, sticks(), look).patches.count(), 3u + 2);
  look.has_fruit = false;
  look.has_blossoms = true;  // five petals and a heart
  EXPECT_EQ(drawn(four_leaves, sticks(), look).patches.count(), 3u + 2 * 6);
  // A lone leaf beside a fork of two keeps its place.
  EXPECT_EQ(drawn(Tree({2, 0, 2, 0, 0}), sticks(), look).patches.count(), 2u + 1 + 6);
  EXPECT_EQ(drawn(Tree({2, 2, 0, 0, 0}), sticks(), look).patches.count(), 2u + 1 + 6);
}

TEST(TreePicture, AutumnLeavesAreLighterTheDeeper) {
  TreeLook look;
  look.shade = 0;
  look.leaves = LeafLook();
  look.leaves->is_autumn = true;
  const Drawing drawing = drawn(Tree({2, 0, 2, 0, 2, 0, 0}), sticks(), look);
  std::vector<double> greens;
  for (std::size_t patch = 0; patch < drawing.patches.count(); ++patch)
    if (drawing.patches.color(patch)[0] > 0.4) greens.push_back(drawing.patches.color(patch)[1]);
  ASSERT_EQ(greens.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(greens));
  EXPECT_LT(greens.front(), greens.back());
}

TEST(TreePicture, AShadowLiesOnTheGround) {
  TreeLook look;
  look.style = TreeLook::Style::bars;
  look.has_shadow = true;
  const Drawing drawing = drawn(four_leaves, sticks(), look);  // seen from the front, the ground is a line
  ASSERT_EQ(drawing.patches.count(), 6u);
  const Bounds trunk = bounds_of(drawing.patches, 3);
  for (std::size_t patch = 0; patch < 3; ++patch) {
    const Bounds shadow = bounds_of(drawing.patches, patch);
    EXPECT_NEAR((shadow[1] + shadow[3]) / 2, trunk[3], 1e-9 + 0.2 * (shadow[3] - shadow[1]));
  }
}

TEST(TreePicture, ALeafByItselfIsADrawing) {
  TreeLook look;
  look.leaves = LeafLook();
  EXPECT_EQ(drawn(Tree({0}), sticks(), look).patches.count(), 0u);
}

TEST(Sheet, PicturesStandInRowsOfOneSize) {
  Sheet sheet(3, 2, true, 100);
  TreeLook look;
  look.style = TreeLook::Style::bars;
  const Shape shape = test::placed(four_leaves, sticks());
  for (const char* caption : {"a", "b", "c"}) sheet.add(caption, four_leaves, shape, look, Cancellation());
  const Drawing& drawing = sheet.drawing();
  EXPECT_EQ(drawing.width, 200);
  EXPECT_EQ(drawing.height, 2 * (100 + 2 * 9.0));
  ASSERT_EQ(drawing.labels.size(), 3u);
  expect_at(drawing.labels[1].place, 150, 104.5);
  expect_at(drawing.labels[2].place, 50, 118 + 104.5);
  const Bounds first = bounds_of(drawing.patches, 0), third = bounds_of(drawing.patches, 6);
  EXPECT_NEAR(third[0], first[0], 1e-9);
  EXPECT_NEAR(third[1], first[1] + 118, 1e-9);
}

TEST(Drawing, APartIsShrunkAndMoved) {
  Drawing page{10, 10, {}, {}}, part{100, 100, {}, {}};
  add_bar(part.patches, {0, 0, 0}, {{10, 20}, {10, 0}, 3, 2});
  part.strokes.push_back({{0, 0, 0}, 4, {{{0, 0}, {100, 100}}}});
  part.labels.push_back({{50, 50}, "x", 12});
  add_drawing(page, part, {1, 2}, 0.1);
  add_drawing(page, part, {1, 2}, 0.1);
  ASSERT_EQ(page.patches.count(), 2u);
  expect_at(page.patches.points(1)[0], 1.7, 4);
  EXPECT_NEAR(page.strokes[1].width, 0.4, 1e-12);
  expect_at(page.strokes[1].lines[0].to, 11, 12);
  expect_at(page.labels[1].place, 6, 7);
}

}  // namespace
}  // namespace ramify
