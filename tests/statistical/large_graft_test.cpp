// Grafted trees of a million nodes have the laws that are computed on a grid of sizes, and not those of the
// next size or parameter. All models and larger trees: scripts/validate.

#include "support/large_graft.hpp"

namespace ramify {
namespace {

class LargeGrafts : public testing::TestWithParam<test::LargeGraft> {};

TEST_P(LargeGrafts, HaveTheLargeLaw) {
  test::expect_the_large_law(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Some, LargeGrafts,
    testing::Values(test::LargeGraft{"bst", "beta(1.1,1.1)", "strahler", 1'000'000, 2000},
                    test::LargeGraft{"patricia(0.23)", "patricia(0.235)", "strahler", 1'000'000, 2000},
                    test::LargeGraft{"bst", "beta(1.1,1.1)", "height", 1'000'000, 1000}));

}  // namespace
}  // namespace ramify
