#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

using Names = std::vector<std::string>;

std::string names_refusal(const Names& names) {
  return test::error_of([&] { StatisticSet::parse(names); });
}

TEST(StatisticSet, RefusesWhatItDoesNotKnow) {
  EXPECT_NE(names_refusal({"stralher"}).find("did you mean strahler?"), std::string::npos);
  EXPECT_NE(names_refusal({"zzzzzzzz"}).find("unknown statistic 'zzzzzzzz'"), std::string::npos);
  EXPECT_NE(names_refusal({"height", "height"}).find("given twice"), std::string::npos);
  EXPECT_NE(names_refusal({}).find("no statistic"), std::string::npos);
}

Names names_of(const std::vector<StatisticColumn>& columns) {
  Names names;
  for (const auto& column : columns) names.push_back(column.name());
  return names;
}

TEST(StatisticSet, NamesItsColumnsBySizeAlone) {
  const auto set = StatisticSet::parse(Names{"height", "streams", "strahler"});
  EXPECT_EQ(names_of(set.columns(0)), (Names{"height", "streams_0", "strahler"}));
  EXPECT_EQ(names_of(set.columns(3)),
            (Names{"height", "streams_0", "streams_1", "streams_2", "streams_3", "strahler"}));
  EXPECT_TRUE(set.contains(statistic::streams));
  EXPECT_FALSE(set.contains(statistic::nodes));
  EXPECT_EQ(names_of(StatisticSet::parse(Names{"tokunaga", "side_branches", "ramification"}).columns(2)),
            (Names{"tokunaga_1", "tokunaga_2", "side_branches_1_0", "side_branches_2_0", "side_branches_2_1",
                   "ramification_1_0", "ramification_1_1", "ramification_2_0", "ramification_2_1",
                   "ramification_2_2"}));
}

TEST(Statistics, HaveEachADifferentName) {
  std::set<std::string_view> names;
  for (const StatisticInfo& info : statistics()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.convention.empty());
    EXPECT_FALSE(info.source.empty());
  }
  for (const char* name :
       {"size", "strahler", "height", "depth", "fill_level", "balance", "nodes", "streams"})
    EXPECT_TRUE(names.contains(name)) << name;
}

// split(0.25), n = 15 is a fixed tree (A6): N = 16,11,4, streams 16,5,1, height 8.
TEST(WriteStatistics, WritesEveryColumnInOrder) {
  const Cancellation never;
  const auto sampler =
      make_tree_sampler({Model::parse("split(0.25)"), whole_trees(orders_and_paths), max_size, &never});
  TreeMeasures measures;
  sampler->sample(15, {0, 0}, 0, measures);
  const auto set = StatisticSet::parse(
      Names{"streams", "size", "nodes", "height", "nodes_mean_ratio", "streams_geometric"});
  std::vector<StatisticValue> row;
  write_statistics(set.columns(4), measures, row);
  ASSERT_EQ(row.size(), set.columns(4).size());
  std::vector<std::int64_t> whole;
  for (std::size_t i = 0; i < 12; ++i) whole.push_back(row[i].whole);
  EXPECT_EQ(whole, (std::vector<std::int64_t>{16, 5, 1, 0, 0, 15, 16, 11, 4, 0, 0, 8}));
  EXPECT_NEAR(row[12].real, (16.0 / 11 + 11.0 / 4) / 2, 1e-14);
  EXPECT_NEAR(row[13].real, 4.0, 1e-14);
}

TEST(WriteStatistics, GivesNoRatioToASingleExternalNode) {
  const Cancellation never;
  const auto sampler =
      make_tree_sampler({Model::parse("bst"), whole_trees(orders_and_paths), max_size, &never});
  TreeMeasures measures;
  sampler->sample(0, {0, 0}, 0, measures);
  EXPECT_EQ(measures.size, 0u);
  EXPECT_EQ(measures.height, 1u);
  EXPECT_EQ(measures.strahler, 0u);
  EXPECT_EQ(measures.depth, 0u);
  EXPECT_EQ(measures.nodes[0], 1u);
  EXPECT_EQ(measures.streams[0], 1u);
  std::vector<StatisticValue> row;
  write_statistics(StatisticSet::parse(Names{"streams_mean_ratio"}).columns(0), measures, row);
  EXPECT_TRUE(std::isnan(row.at(0).real));
}

}  // namespace
}  // namespace ramify
