// Goodness of fit of whole trees: how often a right family is rejected, and a wrong one.
#include "ramify/fit/tree_fit.hpp"

#include <array>
#include <cmath>

#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {
namespace {

constexpr std::array tail_levels{0.01, 0.05, 0.1};

/// Shares of trees whose p-value is at most each level.
std::array<double, tail_levels.size()> rejected(const char* model, Size n, const char* family,
                                                std::uint64_t trees) {
  const Cancellation never;
  const Family* const of = &find_family(family);
  std::array<double, tail_levels.size()> shares{};
  const TreeBatch batch{Model::parse(model), n, test::seed_of("tree fit goodness"), 1, false};
  for (const RecordedTree& tree : batch.grown(0, trees, never)) {
    TreeFitOptions options;
    options.bootstrap = {99, test::seed_of(tree.name)};
    const double p = fit_trees({&tree, 1}, {&of, 1}, options, never)[0].families[0].goodness.p_value;
    for (std::size_t k = 0; k < tail_levels.size(); ++k)
      shares[k] += (p <= tail_levels[k]) / static_cast<double>(trees);
  }
  return shares;
}

TEST(TreeFit, RightFamiliesAreRejectedAsOftenAsTheLevelSays) {
  const std::uint64_t trees = test::replicates(200);
  for (const auto& [model, family] :
       {std::pair{"bst", "bst"}, {"aldous(-1)", "aldous"}, {"dst(0.3)", "dst"}}) {
    const auto shares = rejected(model, 60, family, trees);
    for (std::size_t k = 0; k < tail_levels.size(); ++k) {
      const double deviation = std::sqrt(tail_levels[k] * (1 - tail_levels[k]) / static_cast<double>(trees));
      EXPECT_NEAR(shares[k], tail_levels[k], 4 * deviation) << model << ' ' << tail_levels[k];
    }
  }
}

TEST(TreeFit, WrongFamiliesAreRejected) {
  if (test::sanitized) GTEST_SKIP() << "a twentieth of the trees decides nothing";
  EXPECT_GT(rejected("patricia(0.3)", 1000, "bst", 20)[1], 0.9);
  EXPECT_GT(rejected("patricia(0.3)", 1000, "aldous", 20)[1], 0.9);
  EXPECT_GT(rejected("catalan", 300, "bst", 20)[1], 0.9);
  EXPECT_GT(rejected("beta(5,80)", 300, "aldous", 20)[1], 0.9);
}

}  // namespace
}  // namespace ramify
