// What claims without trees are decided by: all binary trees of a size, and trees that split in one way at
// any size.
#include <array>
#include <numeric>
#include <set>
#include <string>

#include "all_trees.hpp"
#include "one_way_trees.hpp"
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

TEST(AllBinaryTrees, AreAsManyAsCatalanNumbersAndNoneComesTwice) {
  const std::array<std::size_t, 7> catalan_numbers{1, 1, 2, 5, 14, 42, 132};
  for (Size n = 0; n < catalan_numbers.size(); ++n) {
    std::set<std::string> words;
    std::size_t trees = 0;
    for_each_binary_tree(n, {}, [&](const Tree& tree) {
      EXPECT_EQ(tree.size(), n);
      words.insert(to_parentheses(tree));
      ++trees;
    });
    EXPECT_EQ(trees, catalan_numbers[n]);
    EXPECT_EQ(words.size(), trees);
  }
}

// As deterministic_trees_test.cpp has them, of trees that are grown.
TEST(OneWayTrees, HaveThePrintedCounts) {
  const OneWayCounts counts = one_way_counts(Model::parse("split(1/4.35)"), 579);
  EXPECT_EQ(counts.nodes, (std::vector<std::uint64_t>{580, 394, 140, 35, 8, 2}));
  EXPECT_EQ(counts.streams, (std::vector<std::uint64_t>{580, 186, 46, 11, 3, 1}));
}

TEST(OneWayTrees, OfAThousandMillionsOfMillionsAddUp) {
  const Size n = 1'000'000'000'000'000;
  const OneWayCounts counts = one_way_counts(Model::parse("split(0.3)"), n);
  EXPECT_EQ(counts.nodes.front(), n + 1);
  EXPECT_EQ(std::accumulate(counts.nodes.begin() + 1, counts.nodes.end(), std::uint64_t{0}), n);
  EXPECT_EQ(counts.streams.back(), 1u);
}

TEST(OneWayTrees, HaveTheOrdersOfTheirCounts) {
  for (const char* text : {"chain", "complete", "split(0.23)", "split(0.8)"}) {
    const Model model = Model::parse(text);
    const auto orders = one_way_orders(model, 300, {});
    for (Size n = 0; n <= 300; ++n)
      EXPECT_EQ(orders[n] + 1u, one_way_counts(model, n).streams.size()) << text << " n = " << n;
  }
}

}  // namespace
}  // namespace ramify
