// Expected bi-orders against all trees, and the judge of statements that many numbers are 0.
#include "bi_order_means.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "at_infinity.hpp"
#include "exact_range.hpp"
#include "support/definitions.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"

namespace ramify {
namespace {

constexpr std::size_t highest = 3;

TEST(BiOrderMeans, OfTheUniformTreeAreTheMeansOverAllTrees) {
  constexpr Size n = 9;
  const auto shapes = test::all_shapes(n);
  std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> total;
  for (const auto& shape : shapes)
    for (const auto& [orders, count] : test::bi_orders(shape)) total[orders] += count;
  const auto means = build_law(Model::parse("catalan"), n, BiOrderMeans(highest, n));
  const auto mean_of = [&](std::size_t high, std::size_t low) {
    return static_cast<double>(total[{high, low}]) / static_cast<double>(shapes.size());
  };
  for (std::size_t high = 0; high <= highest; ++high)
    for (std::size_t low = 0; low <= high; ++low)
      EXPECT_NEAR(means.joined(n, high, low), mean_of(high, low), 1e-12) << high << ' ' << low;
  const double of_order_2 = mean_of(2, 0) + mean_of(2, 1) + mean_of(1, 1);
  EXPECT_NEAR(means.ramification(n, 2, 1), mean_of(2, 1) / of_order_2, 1e-12);
  EXPECT_NEAR(means.ramification(n, 2, 2), mean_of(1, 1) / of_order_2, 1e-12);
  EXPECT_NEAR(means.tokunaga(n, 2, 0), mean_of(2, 0) / mean_of(1, 1), 1e-12);
}

TEST(AtInfinity, TakesTheTermInOneOverNOff) {
  const auto limit = at_infinity(4096, [](Size n) { return 3 + 5 / static_cast<double>(n); });
  EXPECT_NEAR(limit.value, 3, limit.bound);
  EXPECT_LT(limit.bound, 1e-9);
  const auto curved = at_infinity(64, [](Size n) { return 3 + 5 / std::pow(static_cast<double>(n), 2); });
  EXPECT_NEAR(curved.value, 3, curved.bound);
  EXPECT_GT(curved.bound, 1e-4);
}

TEST(LargestOf, ContainsZeroOnlyWhereEveryNumberMayBeZero) {
  LargestOf largest;
  largest.add(-0.5, 1);
  largest.add(0.25, 0.3);
  EXPECT_EQ(largest.value(), 0.5);
  EXPECT_TRUE(largest.interval().contains(0));
  largest.add(0.25, 0.125);
  EXPECT_EQ(largest.interval().lower, 0.125);
  EXPECT_EQ(largest.interval().upper, 1.5);
}

}  // namespace
}  // namespace ramify
