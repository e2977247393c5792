#include <string>
#include <vector>

#include "support/growing.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/graft_rule.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

using Names = std::vector<std::string>;

TEST(SamplingMethod, IsTheLeastPassThatReadsWhatIsAsked) {
  const auto pass = [](const Names& names, bool graft) {
    const SamplingMethod method = sampling_method(StatisticSet::parse(names), graft);
    EXPECT_EQ(method.graft, graft);
    return method.pass;
  };
  EXPECT_EQ(pass({"size", "strahler", "height", "nodes", "streams"}, true), orders_and_height);
  EXPECT_EQ(pass({"streams_mean_ratio"}, true), orders_and_height);
  EXPECT_EQ(pass({"size"}, true), orders_and_height);
  EXPECT_EQ(pass({"strahler"}, false), orders_and_height);
  EXPECT_EQ(pass({"strahler"}, true), Folded::strahler);
  EXPECT_EQ(pass({"size", "height"}, true), Folded::height);
  EXPECT_EQ(pass({"depth"}, true), Folded::depth);
  EXPECT_EQ(pass({"depth", "strahler"}, true), orders_and_paths);
  EXPECT_EQ(pass({"external_depth", "size"}, true), Folded::external_depth);
  EXPECT_EQ(pass({"external_depth"}, false), all_but_indices);
  for (const char* name : {"sackin", "width", "tokunaga"}) {
    EXPECT_EQ(pass({name}, true), all_but_indices);
    EXPECT_EQ(pass({name}, false), all_but_indices);
  }
  for (const char* name : {"depth", "fill_level", "balance"})
    EXPECT_EQ(pass({name}, false), orders_and_paths);
}

TEST(GraftRule, IsSmallBesideTheTreeAndFitsTheTally) {
  for (const std::string& text : test::all_models()) {
    const Model model = Model::parse(text);
    for (const FoldSet pass : std::initializer_list<FoldSet>{
             orders_and_height, orders_and_paths, Folded::strahler, Folded::height, Folded::fill_level,
             Folded::balance, Folded::depth, orders_and_mean_counts}) {
      const GraftRule rule(model, {pass, true}), whole(model, {pass, false});
      Size last = 0;
      for (Size n = 1; n <= Size{1} << 40; n *= 2) {
        const Size size = rule.size(n);
        EXPECT_LE(size, n / 4) << text << ", n = " << n;
        EXPECT_GE(size, last) << text << ", n = " << n;
        EXPECT_EQ(whole.size(n), 0u);
        EXPECT_LE(rule.grown_nodes(n), static_cast<double>(n) + 1);
        last = size;
      }
      if (pass == orders_and_height || pass == orders_and_paths) {
        EXPECT_LE(last, HortonStrahler::largest_tallied);
      }
    }
  }
}

TEST(GraftRule, SaysWhatIsDrawnAndUpToWhere) {
  const Model model = Model::parse("bst");
  EXPECT_EQ(GraftRule(model, {orders_and_height, false}).describe(1'000'000), "every node is grown");
  EXPECT_EQ(GraftRule(model, {Folded::strahler, true}).describe(1023), "every node is grown");
  EXPECT_EQ(GraftRule(model, {Folded::strahler, true}).describe(1024),
            "strahler of subtrees up to n = 256 drawn from the exact law");
  EXPECT_EQ(GraftRule(model, {orders_and_height, true}).describe(1024),
            "order, height and counts of subtrees up to n = 16 drawn from the exact law");
  EXPECT_EQ(GraftRule(model, {Folded::depth, true}).describe(10), "the walk to the last node alone");
}

}  // namespace
}  // namespace ramify
