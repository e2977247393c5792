// Families given the order, and those that are simulated: moments of what is fitted, and whether intervals
// cover.
#include "ramify/fit/order_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/simulated_counts.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify::test {
namespace {

std::vector<RecordedTree> trees_of_family(const char* family, std::vector<double> values, Size n,
                                          std::uint64_t trees) {
  return TreeBatch{find_family(family).at(values), n, seed_of("order fit"), 2, false}.grown(0, trees,
                                                                                            uninterrupted);
}

/// Streams of a tree as numbers, of the orders 0..S.
std::vector<double> streams_of(const RecordedTree& tree) {
  const auto streams = measure_orders(tree).streams;
  return {streams.begin(), streams.end()};
}

/// What is new at order k: e_k of order_count_fit.hpp.
double fresh(const std::vector<double>& streams, std::size_t k, double a, double c) {
  double rest = streams[k] - 2 * streams[k + 1];
  for (std::size_t j = k + 1; j < streams.size(); ++j)
    rest -= a * std::pow(c, static_cast<double>(j - k) - 1) * streams[j];
  return rest;
}

/// Its covariance with that of order l >= k, given the streams above l.
double covariance_of_fresh(const std::vector<double>& streams, std::size_t k, std::size_t l, double a,
                           double c) {
  double sum = 0;
  for (std::size_t j = l + 1; j < streams.size(); ++j) {
    const double far = a * std::pow(c, static_cast<double>(j - k) - 1);
    const double near = a * std::pow(c, static_cast<double>(j - l) - 1);
    sum += streams[j] * (far * near + (k == l ? far : 0));
  }
  return sum;
}

TEST(OrderCounts, WhatIsNewHasTheMomentsOfSideBranches) {
  constexpr double a = 1.1, c = 2.5;
  std::vector<std::vector<double>> grown;
  for (const RecordedTree& tree : trees_of_family("tokunaga", {a, c}, 5, replicates(4000)))
    grown.push_back(streams_of(tree));
  for (std::size_t k = 0; k < 5; ++k) {
    SampleMean mean, wrong_mean;
    for (const auto& streams : grown) {
      mean.add(fresh(streams, k, a, c));
      wrong_mean.add(fresh(streams, k, a, 1.3 * c));
    }
    EXPECT_TRUE(agrees(z_test(fmt::format("new at order {}", k), mean, 0)));
    if (k < 4) {
      EXPECT_TRUE(rejected(z_test(fmt::format("another c at order {}", k), wrong_mean, 0)));
    }
    for (std::size_t l = k; l < 5; ++l) {
      SampleMean product, poisson;
      for (const auto& streams : grown) {
        const double both = fresh(streams, k, a, c) * fresh(streams, l, a, c);
        product.add(both - covariance_of_fresh(streams, k, l, a, c));
        poisson.add(both);
      }
      EXPECT_TRUE(agrees(z_test(fmt::format("new at orders {} and {}", k, l), product, 0)));
      EXPECT_TRUE(rejected(z_test(fmt::format("independent at {} and {}", k, l), poisson, 0)));
    }
  }
}

/// How many intervals hold the truth, and how many would of half the width.
struct Coverage {
  double truth;
  std::uint64_t trees = 0, covered = 0, shrunk = 0;

  void add(const FittedParameter& found) {
    const double low = (found.lower + found.estimate) / 2, high = (found.upper + found.estimate) / 2;
    ++trees;
    covered += found.lower <= truth && truth <= found.upper ? 1 : 0;
    shrunk += low <= truth && truth <= high ? 1 : 0;
  }

  double p_value(std::uint64_t count) const {
    const boost::math::binomial_distribution<> law(static_cast<double>(trees), 0.95);
    const auto x = static_cast<double>(count);
    return std::min(1.0, 2 * std::min(cdf(law, x), x < 1 ? 1.0 : cdf(complement(law, x - 1))));
  }

  void expect(const std::string& name) const {
    EXPECT_TRUE(agrees({name + ", cover", static_cast<double>(covered), 0, p_value(covered)}));
    EXPECT_TRUE(rejected({name + ", half as wide", static_cast<double>(shrunk), 0, p_value(shrunk)}));
  }
};

TEST(FitGivenOrder, IntervalsCoverTheTruth) {
  Coverage a{1}, c{2}, share{0.5}, higher{0.25};
  for (const RecordedTree& tree : trees_of_family("tokunaga", {1, 2}, 5, replicates(400))) {
    const ObservedBiOrders observed(tree.tree, tree.name);
    const FamilyFit tokunaga = fit_given_order(find_family("tokunaga"), observed);
    a.add(tokunaga.parameters[0]);
    c.add(tokunaga.parameters[1]);
    const FamilyFit matrix = fit_given_order(find_family("ramification"), observed);
    share.add(matrix.parameters[0]);   // p(1,0) = a/(1+a)
    higher.add(matrix.parameters[3]);  // p(2,1) = a/(1+a+ac)
  }
  a.expect("a");
  c.expect("c");
  share.expect("p(1,0)");
  higher.expect("p(2,1)");
}

/// Of three nodes of three: order 2 where both of the others are roots of their own, X = 1 of Bin(3,p) given
/// X <= 1.
TEST(SimulatedCounts, HaveTheLawOfThreeNodes) {
  constexpr double p = 0.2;
  const StreamCounts counts =
      simulated_stream_counts(find_family("ternary"), std::array{p}, 6, uninterrupted);
  const double exact = 3 * p / (1 - p + 3 * p);
  const double error = std::sqrt(exact * (1 - exact) / static_cast<double>(simulated_trees(6)));
  EXPECT_EQ(counts.means[0], 7);
  EXPECT_EQ(counts.covariance(0, 0), 0);
  EXPECT_NEAR(counts.order_tail[2], exact, 5 * error);
  EXPECT_GT(std::abs(counts.order_tail[2] - 3 * p * (1 - p) * (1 - p)), 2 * error) << "X of no condition";
  EXPECT_NEAR(counts.means[1], 1 + exact, 5 * error);
  EXPECT_NEAR(counts.covariance(1, 1), exact * (1 - exact), 5 * error);
}

TEST(SimulatedCounts, TernaryIntervalsCoverTheTruth) {
  if (sanitized) GTEST_SKIP() << "HaveTheLawOfThreeNodes runs the same code";
  Coverage p{0.2};
  CountFitter fitter(2, uninterrupted);
  for (const RecordedTree& tree : trees_of_family("ternary", {0.2}, 500, replicates(300))) {
    const FamilyFit fit = fitter.fit(find_family("ternary"), {measure_orders(tree).streams});
    ASSERT_TRUE(fit.converged);
    p.add(fit.parameters[0]);
  }
  p.expect("ternary");
}

}  // namespace
}  // namespace ramify::test
