#include <vector>

#include <gtest/gtest.h>

#include "ramify/compare/holm.hpp"

namespace ramify {
namespace {

using PValues = std::vector<double>;

void expect_near(const PValues& a, const PValues& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-15);
}

TEST(Holm, MultipliesTheSmallestMost) {
  expect_near(holm_adjusted({0.01, 0.04, 0.03, 0.005}), {0.03, 0.06, 0.06, 0.02});
  expect_near(holm_adjusted({0.5, 0.9}), {1, 1});
  expect_near(holm_adjusted({0.2}), {0.2});
  expect_near(holm_adjusted({}), {});
}

}  // namespace
}  // namespace ramify
