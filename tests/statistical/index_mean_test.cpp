// Sampled means of the indices that are sums over the nodes, against their exact means.
#include <string>

#include "support/columns.hpp"
#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/law/exact_means.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

constexpr Size index_n = 200;

test::SampleMean sampled_index(const StatisticColumn& column, const char* model) {
  const Cancellation never;
  const auto sampler = make_tree_sampler(
      {Model::parse(model), sampling_method(StatisticSet({column.statistic}), true), index_n, &never});
  const StreamKey key{test::seed_of(column.name() + " of " + model), 0};
  test::SampleMean mean;
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < test::replicates(4000); ++replicate) {
    sampler->sample(index_n, key, replicate, measures);
    mean.add(column.real_value(measures));
  }
  return mean;
}

class SumOverNodes : public testing::TestWithParam<std::string> {};

TEST_P(SumOverNodes, HasItsExactMeanAndTellsANearModelApart) {
  const StatisticColumn column = test::column(GetParam());
  const double exact = ExactMeans(Model::parse("aldous(0)"), index_n).moments(column, index_n)->mean;
  EXPECT_TRUE(test::agrees(test::z_test(column.name(), sampled_index(column, "bst"), exact)));
  EXPECT_TRUE(
      test::rejected(test::z_test(column.name() + ", slip", sampled_index(column, "aldous(-0.4)"), exact)));
}

std::vector<std::string> sums_over_nodes() {
  std::vector<std::string> found;
  for (const StatisticInfo& info : statistics())
    if (std::holds_alternative<NodeSum>(info.law.recurrence)) found.emplace_back(info.name);
  return found;
}

INSTANTIATE_TEST_SUITE_P(Every, SumOverNodes, testing::ValuesIn(sums_over_nodes()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace ramify
