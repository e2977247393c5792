#include <cmath>
#include <cstdlib>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/tree/contract_unary.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::refusal_of;
using test::tree_of;
using test::trees_of;
using test::word_of;

TEST(Swc, PointsAreNodes) {
  const RecordedTree tree =
      tree_of("# a comment\n1 3 0 0 0 1 -1\n2 3 3 4 0 0.5 1\n 3 3 3 4 2 0.4 2\r\n4 3 0 0 1 0.25 1\n");
  EXPECT_EQ(to_parentheses(tree.tree), "((E)E)");
  EXPECT_TRUE(std::isnan(tree.lengths[0]));
  EXPECT_EQ(tree.lengths[1], 5);
  EXPECT_EQ(tree.lengths[2], 2);
  EXPECT_EQ(tree.radii[3], 0.25);
  EXPECT_EQ(tree.names[3], "4");
  EXPECT_EQ(tree.places[2], (std::array<double, 3>{3, 4, 2}));
}

TEST(Swc, ChainsContractToBranches) {
  const RecordedTree tree = contract_unary(
      tree_of("1 0 0 0 0 9 -1\n2 0 0 0 1 3 1\n3 0 0 0 4 1 2\n4 0 0 1 4 1 3\n5 0 0 -1 4 1 3\n"));
  EXPECT_EQ(to_parentheses(tree.tree), "(EE)");
  EXPECT_EQ(tree.lengths[0], 4);
  EXPECT_EQ(tree.radii[0], 1.5);  // (1 * 3 + 3 * 1) / 4: the root point has no length
  EXPECT_EQ(tree.places[0], (std::array<double, 3>{0, 0, 4}));
}

TEST(Swc, SomaPointsAreOneNode) {
  // Three soma points as neuromorpho.org writes them, neurites on two of them.
  const std::string text =
      "1 1 0 0 0 5 -1\n2 1 0 -5 0 5 1\n3 1 0 5 0 5 1\n4 3 0 9 0 1 1\n5 2 9 0 0 1 3\n6 2 12 0 0 1 5\n";
  EXPECT_EQ(word_of(text), "((E)E)");
  EXPECT_EQ(tree_of(text).names[1], "5");
  const auto neurites = trees_of(text, {"neurites", 0});
  ASSERT_EQ(neurites.size(), 2u);
  EXPECT_EQ(to_parentheses(neurites[0].tree), "(E)");
  EXPECT_EQ(neurites[0].name, "f#5:axon");
  EXPECT_EQ(neurites[1].name, "f#4:dendrite");
  EXPECT_EQ(to_parentheses(neurites[1].tree), "E");
  EXPECT_EQ(word_of("1 1 0 0 0 5 -1\n2 1 0 -5 0 5 1\n3 1 0 5 0 5 2\n"), "E");
}

TEST(Swc, SeveralRootsAreSaid) {
  const std::string text = "1 2 0 0 0 1 -1\n2 2 0 0 1 1 1\n3 3 5 0 0 1 -1\n";
  EXPECT_EQ(refusal_of(text).find("f:3:1: 2 roots, among them 1 and 3"), 0u) << refusal_of(text);
  EXPECT_EQ(trees_of(text, {"all", 0}).size(), 2u);
  EXPECT_EQ(trees_of(text, {"neurites", 0}).size(), 2u);
  EXPECT_EQ(word_of(text, {"1", 0}), "(E)");
}

TEST(Swc, RefusesWithLineAndColumn) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"1 0 0 0 0 1 -1\n2 0 0 0 1 1\n", "f:2:11: a line of 6 field(s)"},
      {"1 0 0 0 0 1 -1\n2 0 x 0 1 1 1\n", "f:2:5: x = 'x'"},
      {"1 0 0 0 0 1 -1\n2 0 0 0 1e999 1 1\n", "f:2:9: z = '1e999'"},
      {"1 0 0 0 0 1 -1\n2 0 0 0 1 -2 1\n", "f:2:11: radius -2"},
      {"1 0 0 0 0 1 -1\n2.5 0 0 0 1 2 1\n", "f:2:1: id '2.5'"},
      {"1 0 0 0 0 1 -1\n2 0 0 0 1 2 5\n", "f:2:13: parent 5 of node 2 has no row"},
      {"1 0 0 0 0 1 -1\n2 0 0 0 1 2 2\n", "f:2:1: node 2 is its own parent"},
      {"1 0 0 0 0 1 -1\n1 0 0 0 1 2 1\n", "f:2:1: id 1 twice"},
      {"1 0 0 0 0 1 3\n2 0 0 0 1 2 1\n3 0 0 0 0 1 2\n", "f:1:1: a cycle of 3 nodes"},
  };
  for (const auto& c : cases) EXPECT_EQ(refusal_of(c.text).find(c.says), 0u) << c.text << refusal_of(c.text);
}

}  // namespace
}  // namespace ramify
