// file(PATH) that holds the law of another model has all its exact laws.
#include <string>
#include <vector>

#include "support/columns.hpp"
#include "support/split_table_file.hpp"
#include <gtest/gtest.h>

#include "ramify/law/exact_means.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/law/split_rows.hpp"

namespace ramify {
namespace {

class FileLaw : public testing::TestWithParam<const char*> {};

TEST_P(FileLaw, IsThatOfTheModelItHolds) {
  constexpr Size n = 150;
  const Model model = Model::parse(GetParam());
  const test::SplitTableFile file(test::split_table_of(model, n));
  SplitRows rows(model), read(file.model());
  for (Size size = 1; size <= n; ++size) {
    const auto row = rows.row(size), other = read.row(size);
    ASSERT_EQ(row.weights.size(), other.weights.size()) << size;
    EXPECT_EQ(row.first, other.first) << size;
    for (std::size_t m = 0; m < row.weights.size(); ++m)
      EXPECT_NEAR(row.weights[m], other.weights[m], 1e-14) << size;
  }
  const ExactMeans exact(model, n), of_file(file.model(), n);
  for (const char* column : {"strahler", "height", "depth", "fill_level", "balance", "nodes_2", "streams_3"})
    for (const Size size : {Size{2}, Size{37}, n}) {
      const auto truth = exact.moments(test::column(column), size),
                 found = of_file.moments(test::column(column), size);
      EXPECT_NEAR(found->mean, truth->mean, 1e-13 * (1 + truth->mean)) << column << ' ' << size;
      EXPECT_NEAR(found->variance, truth->variance, 1e-12 * (1 + truth->mean * truth->mean))
          << column << ' ' << size;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, FileLaw, testing::Values("bst", "catalan", "beta(10,80)", "split(0.25)"));

TEST(FileLawLimit, ReachesNoFurtherThanItsTable) {
  const test::SplitTableFile file(test::split_table_of(Model::parse("bst"), 20));
  EXPECT_EQ(law_limit(file.model()), 20u);
  EXPECT_EQ(order_moments_limit(file.model()), 20u);
  EXPECT_EQ(ExactMeans(file.model(), 1000).largest_n(), 20u);
}

}  // namespace
}  // namespace ramify
