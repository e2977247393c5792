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
  EXPECT_EQ(pass({"size", "strahler", "height", "nodes", "streams"}, true), Pass::lean);
  EXPECT_EQ(pass({"streams_mean_ratio"}, true), Pass::lean);
  EXPECT_EQ(pass({"size"}, true), Pass::lean);
  EXPECT_EQ(pass({"strahler"}, false), Pass::lean);
  EXPECT_EQ(pass({"strahler"}, true), Pass::strahler);
  EXPECT_EQ(pass({"size", "height"}, true), Pass::height);
  EXPECT_EQ(pass({"depth"}, true), Pass::depth);
  EXPECT_EQ(pass({"depth", "strahler"}, true), Pass::full);
  EXPECT_EQ(pass({"external_depth", "size"}, true), Pass::external_depth);
  EXPECT_EQ(pass({"external_depth"}, false), Pass::all);
  for (const char* name : {"sackin", "width", "tokunaga"}) {
    EXPECT_EQ(pass({name}, true), Pass::all);
    EXPECT_EQ(pass({name}, false), Pass::all);
  }
  for (const char* name : {"depth", "fill_level", "balance"}) EXPECT_EQ(pass({name}, false), Pass::full);
}

TEST(GraftRule, IsSmallBesideTheTreeAndFitsTheTally) {
  for (const std::string& text : test::all_models()) {
    const Model model = Model::parse(text);
    for (const Pass pass : {Pass::lean, Pass::full, Pass::strahler, Pass::height, Pass::fill_level,
                            Pass::balance, Pass::depth, Pass::mean_counts}) {
      const GraftRule rule(model, {pass, true}), whole(model, {pass, false});
      Size last = 0;
      for (Size n = 1; n <= Size{1} << 40; n *= 2) {
        const Size grafted = rule.size(n);
        EXPECT_LE(grafted, n / 4) << text << ", n = " << n;
        EXPECT_GE(grafted, last) << text << ", n = " << n;
        EXPECT_EQ(whole.size(n), 0u);
        EXPECT_LE(rule.grown_nodes(n), static_cast<double>(n) + 1);
        last = grafted;
      }
      if (pass == Pass::lean || pass == Pass::full) {
        EXPECT_LE(last, HortonStrahler::largest_tallied);
      }
    }
  }
}

TEST(GraftRule, SaysWhatIsDrawnAndUpToWhere) {
  const Model model = Model::parse("bst");
  EXPECT_EQ(GraftRule(model, {Pass::lean, false}).describe(1'000'000), "every node is grown");
  EXPECT_EQ(GraftRule(model, {Pass::strahler, true}).describe(1023), "every node is grown");
  EXPECT_EQ(GraftRule(model, {Pass::strahler, true}).describe(1024),
            "strahler of subtrees up to n = 256 drawn from the exact law");
  EXPECT_EQ(GraftRule(model, {Pass::lean, true}).describe(1024),
            "order, height and counts of subtrees up to n = 16 drawn from the exact law");
  EXPECT_EQ(GraftRule(model, {Pass::depth, true}).describe(10), "the walk to the last node alone");
}

}  // namespace
}  // namespace ramify
