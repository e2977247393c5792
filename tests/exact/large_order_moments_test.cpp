#include <cmath>
#include <vector>

#include "support/sanitized.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_moments.hpp"

namespace {

using ramify::Approximation;
using ramify::LargeOrders;
using ramify::Model;
using ramify::OrderCount;
using ramify::Size;

constexpr auto of_nodes = OrderCount::Of::nodes, of_streams = OrderCount::Of::streams;

/// Nodes and streams of the orders from 0 to one that no tree of 4096 nodes has.
std::vector<OrderCount> counts_to_order_13() {
  std::vector<OrderCount> counts;
  for (std::size_t k = 0; k <= 13; ++k)
    for (const auto of : {of_nodes, of_streams}) counts.push_back({of, k});
  return counts;
}

void expect_those_of_the_exact_law(const char* text, Size n) {
  const Model model = Model::parse(text);
  const auto means = ramify::build_law(model, n, ramify::OrderMeans(n));
  const auto exact = ramify::build_law(model, n, ramify::OrderMoments(means, n));
  LargeOrders large(model, {static_cast<double>(n)});
  const auto leaves = static_cast<double>(n + 1);
  for (const OrderCount a : counts_to_order_13()) {
    for (const OrderCount b : counts_to_order_13()) {
      const Approximation found = large.covariance(static_cast<double>(n), a, b);
      const double truth = exact.covariance(n, a, b), off = std::abs(found.value - truth);
      EXPECT_LE(off, 1e-9 * leaves) << text << " orders " << a.order << " " << b.order;
      // The exact law itself is right to 1e-13 of the leaves.
      EXPECT_LE(off, found.error + 1e-12 * leaves) << text << " orders " << a.order << " " << b.order;
      EXPECT_LE(found.error, 1e-7 * leaves) << text << " orders " << a.order << " " << b.order;
    }
  }
}

TEST(LargeOrderMoments, OfPatriciaAreThoseOfTheExactLaw) {
  expect_those_of_the_exact_law("patricia(0.23)", ramify::test::sanitized ? 2500 : 4096);
}

TEST(LargeOrderMoments, OfBstAreThoseOfTheExactLaw) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  expect_those_of_the_exact_law("bst", 3000);
}

TEST(LargeOrderMoments, OfCatalanAreThoseOfTheExactLaw) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  expect_those_of_the_exact_law("catalan", 3000);
}

/// Var M_1 of a binary search tree is 2(n+1)/45 at every n >= 4; those of other low orders are linear in n+1
/// too, up to what large orders hide, so that a small exact law knows them.
TEST(LargeOrderMoments, OfBstGrowLinearly) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  constexpr double n = 1e9;
  constexpr Size small = 500;
  const Model bst = Model::parse("bst");
  const auto means = ramify::build_law(bst, small, ramify::OrderMeans(small));
  const auto exact = ramify::build_law(bst, small, ramify::OrderMoments(means, small));
  LargeOrders large(bst, {n});
  EXPECT_NEAR(large.variance(n, {of_streams, 1}).value / (n + 1), 2.0 / 45, 1e-12);
  for (const OrderCount a : {OrderCount{of_nodes, 1}, OrderCount{of_streams, 1}, OrderCount{of_streams, 2}})
    for (const OrderCount b : {OrderCount{of_nodes, 1}, OrderCount{of_streams, 2}})
      EXPECT_NEAR(large.covariance(n, a, b).value / (n + 1), exact.covariance(small, a, b) / (small + 1.0),
                  1e-9)
          << a.order << " " << b.order;
}

/// Cherries of uniform binary trees: m(m-1)(m-2)(m-3) / (2 (2m-3)^2 (2m-5)), m leaves (McKenzie and Steel
/// 2000).
TEST(LargeOrderMoments, OfCatalanCherriesAreKnown) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  constexpr double n = 1e7, m = n + 1;
  LargeOrders large(Model::parse("catalan"), {n});
  const double truth = m * (m - 1) * (m - 2) * (m - 3) / (2 * (2 * m - 3) * (2 * m - 3) * (2 * m - 5));
  EXPECT_NEAR(large.variance(n, {of_streams, 1}).value / truth, 1, 1e-11);
}

/// As covariances are (Cauchy and Schwarz).
TEST(LargeOrderMoments, AreSymmetricAndPositive) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  constexpr double n = 1e6;
  LargeOrders large(Model::parse("beta(2,2)"), {n});
  for (std::size_t k = 1; k <= 9; ++k) {
    const double node = large.variance(n, {of_nodes, k}).value,
                 stream = large.variance(n, {of_streams, k}).value,
                 both = large.covariance(n, {of_nodes, k}, {of_streams, k}).value;
    EXPECT_DOUBLE_EQ(both, large.covariance(n, {of_streams, k}, {of_nodes, k}).value);
    EXPECT_GT(node, 0);
    EXPECT_GT(stream, 0);
    EXPECT_LE(both * both, node * stream * (1 + 1e-9)) << k;
  }
}

TEST(LargeOrderMoments, AreRefusedWhereMeansAreKnownTooBadly) {
  if (ramify::test::sanitized) GTEST_SKIP() << "OfPatricia runs the same code";
  LargeOrders large(Model::parse("bst"), {1e6, 1e16});
  EXPECT_GT(large.variance(1e6, {of_streams, 1}).value, 0);
  EXPECT_THROW(large.variance(1e16, {of_streams, 1}), ramify::Error);
}

}  // namespace
