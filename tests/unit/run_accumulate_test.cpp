#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/accumulate/order_totals.hpp"
#include "ramify/accumulate/real_summary.hpp"
#include "ramify/accumulate/whole_summary.hpp"

namespace ramify {
namespace {

TEST(WholeSummary, IsTheTextbookMeanAndVariance) {
  WholeSummary sums;
  for (const std::int64_t value : {3, 1, 4, 1, 5, 9, 2, 6}) sums.add(value);
  EXPECT_EQ(sums.count(), 8u);
  EXPECT_DOUBLE_EQ(sums.mean(), 31.0 / 8);
  EXPECT_DOUBLE_EQ(sums.variance(), (173 - 31.0 * 31 / 8) / 7);
  EXPECT_EQ(sums.min(), 1);
  EXPECT_EQ(sums.max(), 9);
}

TEST(WholeSummary, QuantileIsTheSmallestValueThatReachesTheLevel) {
  WholeSummary sums;
  for (std::int64_t value = 1; value <= 10; ++value) sums.add(value);
  EXPECT_EQ(sums.quantile(0.05), 1);
  EXPECT_EQ(sums.quantile(0.5), 5);
  EXPECT_EQ(sums.quantile(0.51), 6);
  EXPECT_EQ(sums.quantile(1), 10);
}

TEST(WholeSummary, KeepsTheVarianceOfHugeNumbersThatDoublesLose) {
  WholeSummary sums;
  const std::int64_t huge = std::int64_t{1} << 60;
  for (const std::int64_t offset : {-1, 0, 1}) sums.add(huge + offset);
  EXPECT_DOUBLE_EQ(sums.variance(), 1);
}

TEST(WholeSummary, MergesInAnyOrder) {
  WholeSummary a, b, ab, ba;
  for (const std::int64_t value : {1, 2, 2}) a.add(value);
  for (const std::int64_t value : {2, 7}) b.add(value);
  ab.merge(a), ab.merge(b), ba.merge(b), ba.merge(a);
  EXPECT_EQ(ab.occurrences(), ba.occurrences());
  EXPECT_EQ(ab.count(), 5u);
}

TEST(RealSummary, QuantilesMatchTheWholeOnes) {
  RealSummary reals;
  for (int value = 10; value >= 1; --value) reals.add(value);
  EXPECT_EQ(reals.quantiles({0.05, 0.5, 0.51, 1}), (std::vector<double>{1, 5, 6, 10}));
  EXPECT_DOUBLE_EQ(reals.mean(), 5.5);
  EXPECT_DOUBLE_EQ(reals.variance(), 82.5 / 9);
}

TEST(RealSummary, InterpolatesBetweenOrderStatistics) {
  RealSummary reals;
  for (const double value : {4.0, 1.0, 2.0}) reals.add(value);
  EXPECT_EQ(reals.interpolated_quantiles({0, 0.25, 0.5, 0.75, 1}), (std::vector<double>{1, 1.5, 2, 3, 4}));
}

/// Counts of orders 0 and 1 of three trees.
OrderTotals three_trees() {
  OrderTotals totals;
  for (const auto& [leaves, ones] : {std::pair{10u, 4u}, std::pair{12u, 3u}, std::pair{8u, 5u}}) {
    HortonStrahler::Counts counts{};
    counts[0] = leaves;
    counts[1] = ones;
    totals.add(counts, 1);
  }
  return totals;
}

TEST(OrderTotals, PooledRatioIsTheRatioOfSumsWithItsDeltaMethodError) {
  const auto ratio = three_trees().pooled_ratio(0);
  EXPECT_DOUBLE_EQ(ratio.value, 30.0 / 12);
  // The literal formula: the variance of N_0 - r N_1 over trees, divided by trees and the squared mean of
  // N_1.
  const double residuals[] = {10 - 2.5 * 4, 12 - 2.5 * 3, 8 - 2.5 * 5};
  double squares = 0;
  for (const double residual : residuals) squares += residual * residual;
  EXPECT_NEAR(ratio.standard_error, std::sqrt(squares / 2 / 3) / 4, 1e-12);
}

TEST(OrderTotals, MeanHasTheErrorOfAMean) {
  const auto mean = three_trees().mean(0);
  EXPECT_DOUBLE_EQ(mean.value, 10);
  EXPECT_NEAR(mean.standard_error, std::sqrt(4.0 / 3), 1e-12);
}

TEST(OrderTotals, MergedBlocksAreTheWhole) {
  OrderTotals merged = three_trees();
  merged.merge(three_trees());
  EXPECT_EQ(merged.trees(), 6u);
  EXPECT_DOUBLE_EQ(merged.pooled_ratio(0).value, 2.5);
}

}  // namespace
}  // namespace ramify
