// A tree that is folded while it grows and the same tree stored and measured have the same statistics.
#include <string>

#include "support/growing.hpp"
#include "support/grown_cases.hpp"
#include "support/uninterrupted.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/measure_tree.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

/// The walks are random, and a stored tree is folded in another order.
void expect_same_but_for_the_walks(const TreeMeasures& a, const TreeMeasures& b, std::size_t orders) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.strahler, b.strahler);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.fill_level, b.fill_level);
  EXPECT_EQ(a.balance, b.balance);
  EXPECT_EQ(a.path_length, b.path_length);
  EXPECT_EQ(a.sackin, b.sackin);
  EXPECT_EQ(a.colless, b.colless);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.streams, b.streams);
  for (std::size_t high = 0; high < orders; ++high)
    for (std::size_t low = 0; low <= high; ++low)
      EXPECT_EQ(a.bi_orders.joined(high, low), b.bi_orders.joined(high, low));
}

TEST(MeasureTree, SeesWhatTheGrowingPassSees) {
  for (const std::string& text : test::all_models()) {
    const Model model = Model::parse(text);
    const auto all = make_tree_sampler({model, whole_trees(all_but_indices), max_size, &test::uninterrupted});
    const auto full =
        make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &test::uninterrupted});
    for (const Size n : {0u, 1u, 2u, 7u, 100u, 20'000u}) {
      SCOPED_TRACE(text + ", n = " + std::to_string(n));
      const StreamKey key{7, model.stream_cell(n)};
      TreeMeasures grown, less;
      all->sample(n, key, 3, grown);
      full->sample(n, key, 3, less);
      expect_same_but_for_the_walks(grown, measure_tree(test::grown_tree(model, n, key, 3), key, 3), 20);
      EXPECT_EQ(grown.depth, less.depth);
      EXPECT_EQ(grown.nodes, less.nodes);
      EXPECT_EQ(grown.balance, less.balance);
    }
  }
}

TEST(MeasureTree, SeesTheOrdersThatAreAskedForAlone) {
  auto cases = test::grown_cases();
  cases.insert(cases.end(), {{"kary(3)", 1}, {"branching(0,1,0)", 5}});  // a leaf, a path
  for (const auto& [text, n] : cases) {
    const Model model = Model::parse(text);
    const Tree tree = test::grown_tree(model, n, {7, 8}, 9);
    const TreeMeasures all = measure_tree(tree, {7, 8}, 9),
                       orders = measure_tree(tree, {7, 8}, 9, orders_and_height);
    EXPECT_EQ(orders.size, all.size) << text;
    EXPECT_EQ(orders.strahler, all.strahler) << text;
    EXPECT_EQ(orders.height, all.height) << text;
    EXPECT_EQ(orders.nodes, all.nodes) << text;
    EXPECT_EQ(orders.streams, all.streams) << text;
  }
}

}  // namespace
}  // namespace ramify
