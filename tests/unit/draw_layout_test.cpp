// Where nodes lie, by hand on small trees, to 1e-12; no pixels.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/core/utf8.hpp"
#include "ramify/draw/label_text.hpp"
#include "ramify/draw/node_link.hpp"
#include "ramify/draw/order_pens.hpp"
#include "ramify/draw/tree_layout.hpp"

namespace ramify {
namespace {

void expect_near(const std::vector<double>& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-12) << i;
}

/// (tip, (tip, tip)).
const Tree cherry_on_the_right({2, 0, 2, 0, 0});

TEST(TreeLayout, TipsAreOneApartAndForksMidway) {
  const TreeLayout layout = lay_out(cherry_on_the_right, {});
  expect_near(layout.across, {0.75, 0, 1.5, 1, 2});
  expect_near(layout.along, {0, 1, 1, 2, 2});
  EXPECT_EQ(layout.width, 2);
  EXPECT_EQ(layout.length, 2);
}

TEST(TreeLayout, LengthsAddUpFromTheRootsOwn) {
  const TreeLayout layout = lay_out(cherry_on_the_right, std::vector{0.5, 1.0, 0.25, 2.0, 3.0});
  expect_near(layout.along, {0.5, 1.5, 0.75, 2.75, 3.75});
  EXPECT_EQ(layout.length, 3.75);
}

TEST(TreeLayout, AForkOfThreeLiesMidwayBetweenItsOuterChildren) {
  // ((tip, tip), tip, tip, one-child node over a tip)
  expect_near(lay_out(Tree({4, 2, 0, 0, 0, 0, 1, 0}), {}).across, {2.25, 0.5, 0, 1, 2, 3, 4, 4});
}

TEST(TreeLayout, OneNodeAndALongChain) {
  const TreeLayout one = lay_out(Tree({0}), {});
  expect_near(one.across, {0});
  EXPECT_EQ(one.length, 0);
  std::vector<std::uint32_t> chain;
  for (int i = 0; i < 100'000; ++i) chain.insert(chain.end(), {2, 0});
  chain.push_back(0);
  EXPECT_EQ(lay_out(Tree(chain), {}).length, 100'000);
}

RecordedTree recorded(std::vector<double> lengths = {}) {
  RecordedTree tree{"small", cherry_on_the_right, std::move(lengths), {}, {}};
  tree.names.set(1, "oak");
  return tree;
}

/// The ends of the lines of one order, as x, y, x, y.
std::vector<double> ends(const Drawing& drawing, std::size_t order) {
  std::vector<double> ends;
  for (const auto& [from, to] : drawing.strokes[order].lines)
    ends.insert(ends.end(), {from.x, from.y, to.x, to.y});
  return ends;
}

// 720 along, 120 across for three tips, a margin of 20 and a head of 64: a tip lies every 40 from 84 + 20 on.
TEST(NodeLink, ADendrogramHasRightAngles) {
  const Drawing drawing = node_link_diagram(recorded({0, 1, 2, 2, 2}), {});
  // Order 1, the fork: its branch begins at the root (x = 20, y = 104 + 40 * 0.75 = 134) and turns at y =
  // 164.
  expect_near(ends(drawing, 1), {20, 134, 20, 134, 20, 134, 20, 164, 20, 164, 380, 164});
  expect_near(ends(drawing, 0), {20,  134, 20,  104, 20,  104, 200, 104, 380, 164, 380, 144,
                                 380, 144, 740, 144, 380, 164, 380, 184, 380, 184, 740, 184});
}

TEST(NodeLink, AnUprightTreeGrowsFromTheBottom) {
  const Drawing drawing = node_link_diagram(recorded(), {NodeLinkStyle::Form::upright});
  const auto lines = ends(drawing, 0);
  ASSERT_EQ(lines.size(), 12u);
  EXPECT_GT(lines[1], lines[3]);                  // y goes down
  EXPECT_NEAR(lines[1] - lines[3], 360, 1e-12);   // one of two edges
  EXPECT_NEAR(lines[0], 20 + 240 * 1.25, 1e-12);  // as wide as it is high
}

TEST(NodeLink, ColoursAndWidthsFollowTheOrder) {
  const Drawing drawing = node_link_diagram(recorded(), {});
  const OrderPens pens(1, drawing.strokes[0].width);
  EXPECT_EQ(drawing.strokes[0].color, pens.color(0));
  EXPECT_EQ(drawing.strokes[1].color, pens.color(1));
  EXPECT_LT(drawing.strokes[0].width, drawing.strokes[1].width);
  EXPECT_NEAR(OrderPens(20, 0.3).width(20), 9, 1e-12);
}

bool has_label(const Drawing& drawing, const std::string& text) {
  for (const Label& label : drawing.labels)
    if (label.text == text) return true;
  return false;
}

TEST(NodeLink, NamesKeyAndScaleAreWritten) {
  const Drawing drawing = node_link_diagram(recorded({0, 1, 2, 2, 2}), {.leaf_order = 1});
  for (const char* text :
       {"small", "oak", "Horton-Strahler order, leaf order 1", "1", "2", "1 in the unit of the file"})
    EXPECT_TRUE(has_label(drawing, text)) << text;
  EXPECT_FALSE(has_label(node_link_diagram(recorded(), {}), "1 in the unit of the file"));
}

TEST(NodeLink, ALengthThatIsNoneIsRefused) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (const double length : {unknown, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_NE(test::error_of([&] { node_link_diagram(recorded({0, length, 1, 1, 1}), {}); }), "") << length;
  EXPECT_EQ(
      test::error_of([&] { node_link_diagram(recorded({0, unknown, 1, 1, 1}), {}); }),
      "small: node 2 (oak) has the length nan (a branch is drawn to scale, or none is): add --same-lengths");
  EXPECT_NE(test::error_of([&] { node_link_diagram(recorded({1e308, 1e308, 1, 1, 1}), {}); }), "");
  EXPECT_EQ(test::error_of([&] { node_link_diagram(recorded({unknown, 1, 1, 1, 1}), {}); }), "");
  EXPECT_EQ(
      test::error_of([&] { node_link_diagram(recorded({0, unknown, 1, 1, 1}), {.same_lengths = true}); }),
      "");
}

// ((tip, tip), (tip, (tip, tip))): by hand.
TEST(NodeLink, NumbersStandAtTheNodes) {
  const Tree tree({2, 2, 0, 0, 2, 0, 2, 0, 0});
  using Numbers = std::vector<std::uint64_t>;
  EXPECT_EQ(node_numbers(tree, NodeNumber::order, 0), (Numbers{2, 1, 0, 0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(node_numbers(tree, NodeNumber::order, 1), (Numbers{3, 2, 1, 1, 2, 1, 2, 1, 1}));
  EXPECT_EQ(node_numbers(tree, NodeNumber::depth, 1), (Numbers{1, 2, 3, 3, 2, 3, 3, 4, 4}));
  EXPECT_EQ(node_numbers(tree, NodeNumber::leaves, 1), (Numbers{5, 2, 1, 1, 3, 1, 2, 1, 1}));
  EXPECT_EQ(node_numbers(tree, NodeNumber::balance, 1), (Numbers{2, 1, 0, 0, 1, 0, 1, 0, 0}));
  EXPECT_NE(test::error_of([] { parse_node_number("debth"); }).find("did you mean depth"), std::string::npos);
  const Drawing drawing = node_link_diagram({"small", tree, {}, {}, {}}, {.number = NodeNumber::leaves});
  const auto& discs = drawing.strokes[3].lines;  // after those of orders 0 to 2
  ASSERT_EQ(discs.size(), 9u);
  EXPECT_EQ(drawing.labels[0].text, "5");
  EXPECT_EQ(drawing.labels[0].place.x, discs[0].from.x);
  EXPECT_EQ(drawing.labels[0].place.y, discs[0].to.y);
  std::vector<std::uint32_t> bush{301};
  bush.insert(bush.end(), 301, 0);
  const RecordedTree large{"bush", Tree(bush), {}, {}, {}};
  EXPECT_NE(test::error_of([&] {
              node_link_diagram(large, {.number = NodeNumber::order});
            }).find("leave --label out"),
            std::string::npos);
}

/// B* word for word (B17), |u| being external nodes: a one-child node's other subtree and both of an external
/// node are empty, and an empty one has 0.
class PrintedBalance {
 public:
  explicit PrintedBalance(const Tree& tree) : numbers(tree.node_count()) { subtree(tree, 0); }

  std::vector<std::uint64_t> numbers;

 private:
  struct Subtree {
    std::size_t nodes = 0;
    std::uint64_t size = 0, balance = 0;
  };

  Subtree subtree(const Tree& tree, std::size_t u) {
    std::size_t next = u + 1;
    std::array<Subtree, 2> below;
    for (std::uint32_t child = 0; child < tree.arity(u); ++child) {
      below[child] = subtree(tree, next);
      next += below[child].nodes;
    }
    const auto [v, w] = below;
    numbers[u] = std::max(v.balance + (v.size <= w.size ? 1 : 0), w.balance + (w.size <= v.size ? 1 : 0));
    return {next - u, tree.arity(u) == 0 ? 1 : v.size + w.size, numbers[u]};
  }
};

TEST(NodeLink, AlternateBalancesAreThoseThatBeginAtEmptySubtrees) {
  using Numbers = std::vector<std::uint64_t>;
  const Tree trie({2, 1, 1, 2, 0, 0, 2, 2, 0, 0, 0});  // of A12, whose balance number is 2
  const NodeNumber alternate = parse_node_number("alternate_balance");
  EXPECT_EQ(node_numbers(trie, NodeNumber::balance, 1)[0], 2u);
  EXPECT_EQ(node_numbers(trie, alternate, 1), (Numbers{3, 2, 2, 2, 1, 1, 2, 2, 1, 1, 1}));
  for (const Tree& tree :
       {trie, Tree({0}), Tree({1, 0}), Tree({2, 2, 0, 0, 2, 0, 2, 0, 0}), Tree({2, 0, 2, 0, 2, 0, 0})})
    EXPECT_EQ(node_numbers(tree, alternate, 1), PrintedBalance(tree).numbers);
}

TEST(NodeLink, OneNodeIsADrawing) {
  const Drawing drawing = node_link_diagram({"tip", Tree({0}), {}, {}, {}}, {});
  EXPECT_EQ(drawing.strokes[0].lines.size(), 1u);
}

TEST(LabelText, IsAlwaysUtf8) {
  EXPECT_EQ(label_text("Quercus robur"), "Quercus robur");
  EXPECT_EQ(label_text("ch\xc3\xaane\t1"), "chêne 1");
  EXPECT_EQ(label_text("ch\xeane"), "ch?ne");              // Latin-1
  EXPECT_EQ(label_text("\xc0\xaf\xed\xa0\x80"), "?????");  // too long; a surrogate
  EXPECT_EQ(label_text("\xf0\x9f\x8c\xb3 tree", 3), "🌳 t…");
  EXPECT_EQ(character_count("chêne"), 5u);
}

}  // namespace
}  // namespace ramify
