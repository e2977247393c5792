#include <functional>
#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/statistic/node_labels.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

/// What a definition says of every subtree, in preorder.
template <class Value>
std::vector<Value> in_preorder(const test::Shape& shape,
                               const std::function<Value(const test::Shape&)>& define) {
  std::vector<Value> values{define(shape)};
  for (const auto& child : shape.children) {
    const auto below = in_preorder(child, define);
    values.insert(values.end(), below.begin(), below.end());
  }
  return values;
}

void depths_in_preorder(const test::Shape& shape, std::uint32_t depth, std::vector<std::uint32_t>& depths) {
  depths.push_back(depth);
  for (const auto& child : shape.children) depths_in_preorder(child, depth + 1, depths);
}

void expect_label_definitions(const test::Shape& shape) {
  const std::string word = test::to_word(shape);
  SCOPED_TRACE(word);
  const Tree tree = from_parentheses(word);
  EXPECT_EQ(strahler_orders(tree), in_preorder<std::uint8_t>(shape, [](const auto& s) {
              return static_cast<std::uint8_t>(test::strahler(s));
            }));
  EXPECT_EQ(magnitudes(tree), in_preorder<Size>(shape, test::external_nodes));
  EXPECT_EQ(horsfield_orders(tree), in_preorder<std::uint32_t>(shape, [](const auto& s) {
              return static_cast<std::uint32_t>(test::height(s));
            }));
  std::vector<std::uint32_t> expected;
  depths_in_preorder(shape, 1, expected);
  EXPECT_EQ(depths(tree), expected);
  for (auto& order : expected) order = static_cast<std::uint32_t>(test::height(shape)) - order + 1;
  EXPECT_EQ(horsfield_orders_from_root(tree), expected);
}

TEST(NodeLabels, AreTheDefinitions) {
  for (std::size_t n = 0; n <= 6; ++n)
    for (const auto& shape : test::all_shapes(n)) expect_label_definitions(shape);
  for (const char* word : {"(EEE)", "((E)(EE))", "(E((EEE)(EEE)(EEE))(EE)E)"})
    expect_label_definitions(test::read_shape(word));
}

// X35: the two Horsfield orders agree on longest paths alone.
TEST(HorsfieldOrders, DifferOffTheLongestPaths) {
  const Tree tree = from_parentheses("(E(EE))");
  EXPECT_EQ(horsfield_orders(tree), (std::vector<std::uint32_t>{3, 1, 2, 1, 1}));
  EXPECT_EQ(horsfield_orders_from_root(tree), (std::vector<std::uint32_t>{3, 2, 2, 1, 1}));
}

using PathCounts = std::vector<PathNodes>;

TEST(PathNodes, FollowTheirRule) {
  const Tree tree = from_parentheses("(E(EE))");
  EXPECT_EQ(path_nodes(tree, MainChild::first), (PathCounts{{1, 0}, {2, 0}, {1, 1}, {2, 1}, {1, 2}}));
  EXPECT_EQ(path_nodes(tree, MainChild::largest), (PathCounts{{1, 0}, {1, 1}, {2, 0}, {3, 0}, {2, 1}}));
  EXPECT_EQ(path_nodes(tree, MainChild::highest_order), (PathCounts{{1, 0}, {1, 1}, {2, 0}, {3, 0}, {2, 1}}));
  EXPECT_EQ(path_nodes(from_parentheses("E"), MainChild::first), (PathCounts{{1, 0}}));
}

// Order and size choose differently: a chain of three nodes against two of order 2.
TEST(PathNodes, TellOrderFromSize) {
  const Tree tree = from_parentheses("((E(E(E(EE))))((EE)(EE)))");
  const auto by_size = path_nodes(tree, MainChild::largest),
             by_order = path_nodes(tree, MainChild::highest_order);
  EXPECT_EQ(by_size[1], (PathNodes{2, 0}));
  EXPECT_EQ(by_order[1], (PathNodes{1, 1}));
}

TEST(PathNodes, AddUpToTheDepth) {
  for (const auto& shape : test::all_shapes(5)) {
    const Tree tree = from_parentheses(test::to_word(shape));
    const auto depth = depths(tree);
    for (const MainChild rule : {MainChild::first, MainChild::largest, MainChild::highest_order}) {
      const auto counts = path_nodes(tree, rule);
      for (std::size_t node = 0; node < counts.size(); ++node)
        EXPECT_EQ(counts[node].main + counts[node].secondary, depth[node]);
    }
  }
}

}  // namespace
}  // namespace ramify
