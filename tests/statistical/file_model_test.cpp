// Trees of file(PATH) that holds the law of another model have its law; one that holds a near law is told
// apart.
#include <string>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/seed.hpp"
#include "support/split_table_file.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr Size table_size = 200;

test::Tally tally(const Model& model, const std::string& tag) {
  test::Tally tally;
  test::grow_and_measure(model, table_size, 20000, test::seed_of(tag),
                         [&](const TreeMeasures& m) { ++tally[{m.strahler, m.height}]; });
  return tally;
}

class FileModel : public testing::TestWithParam<const char*> {};

TEST_P(FileModel, GrowsTheTreesOfTheModelItHolds) {
  const Model model = Model::parse(GetParam());
  const test::SplitTableFile file(test::split_table_of(model, table_size)),
      near(test::split_table_of(Model::parse("beta(1.2,1.2)"), table_size));
  const auto trees = tally(model, model.text());
  EXPECT_TRUE(
      test::agrees(test::two_samples(model.text() + " and file", tally(file.model(), "file"), trees)));
  EXPECT_TRUE(test::rejected(
      test::two_samples(model.text() + " and file of beta(1.2,1.2)", tally(near.model(), "near"), trees)));
}

TEST_P(FileModel, SplitsAsItsTableSays) {
  const Model model = Model::parse(GetParam());
  const test::SplitTableFile file(test::split_table_of(model, table_size));
  const auto counts = test::count_splits(file.model().text(), table_size, 400000,
                                         test::seed_of("splits of a file"), test::default_tables);
  const auto pmf = split_pmf(model, table_size);
  EXPECT_TRUE(test::agrees(test::chi_square(model.text() + " from a file", counts, pmf)));
}

INSTANTIATE_TEST_SUITE_P(Models, FileModel, testing::Values("bst", "catalan", "dst(0.3)"));

}  // namespace
}  // namespace ramify
