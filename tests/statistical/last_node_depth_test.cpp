#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/model_cases.hpp"
#include "support/reference_laws.hpp"
#include "support/seed.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

using DepthLaw = std::vector<double>;  // P(D = d), d = 0..

/// P(D_n = d) by the recurrence of B23: D_1 = 1; D_n = 1 + D_i with probability i/(n-1) for a child of size
/// i. fair: the slip that goes to either internal child with equal probability.
DepthLaw depth_law(Size n, const test::SplitPmf& split, bool fair) {
  std::vector<DepthLaw> laws{{1}, {0, 1}};
  for (Size size = 2; size <= n; ++size) {
    DepthLaw law(size + 1, 0.0);
    const auto left = split(size);
    const auto go = [&](Size child, double probability) {
      for (std::size_t d = 0; d < laws[child].size(); ++d) law[d + 1] += probability * laws[child][d];
    };
    for (Size i = 0; i < size; ++i) {
      const Size j = size - 1 - i;
      const double others = static_cast<double>(size - 1);
      const bool fork = fair && i > 0 && j > 0;
      if (i > 0) go(i, left[i] * (fork ? 0.5 : static_cast<double>(i) / others));
      if (j > 0) go(j, left[i] * (fork ? 0.5 : static_cast<double>(j) / others));
    }
    laws.push_back(law);
  }
  return laws[n];
}

void expect_depth_law(const std::string& model, const test::SplitPmf& split) {
  for (const Size n : {2u, 10u, 40u}) {
    std::vector<std::uint64_t> counts(n + 1, 0);
    test::grow_and_measure(Model::parse(model), n, 100000, test::seed_of("last node of " + model),
                           [&](const TreeMeasures& m) { ++counts.at(m.depth); });
    const auto what = fmt::format("{}, depth of the last node, n = {}", model, n);
    EXPECT_TRUE(test::agrees(test::chi_square(what, counts, depth_law(n, split, false))));
    if (n == 2) continue;  // one fork never has two internal children
    EXPECT_TRUE(test::rejected(
        test::chi_square(what + ": children equally likely", counts, depth_law(n, split, true))));
  }
}

TEST(LastNodeDepthLaw, OfBsts) {
  expect_depth_law("bst", test::uniform_law);
}

TEST(LastNodeDepthLaw, OfCatalanTrees) {
  expect_depth_law("catalan", test::catalan_law);
}

TEST(LastNodeDepthLaw, OfDsts) {
  expect_depth_law("dst(0.23)", [](Size n) { return test::dst_law(n, 0.23); });
}

TEST(LastNodeDepthLaw, OfPatriciaTrees) {
  expect_depth_law("patricia(0.23)", [](Size n) { return test::patricia_law(n, 0.23); });
}

// The hand recurrence itself: E D_3 of a BST is 1 + (2/3) 2 + (1/3) 1 = 8/3.
TEST(LastNodeDepthLaw, IsTheHandRecurrence) {
  const auto law = depth_law(3, test::uniform_law, false);
  EXPECT_NEAR(law[2], 1.0 / 3, 1e-15);
  EXPECT_NEAR(law[3], 2.0 / 3, 1e-15);
}

}  // namespace
}  // namespace ramify
