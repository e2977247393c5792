// The laws of stream counts that fits ask for, on one coarse grid, against the exact ones and the fine ones.
#include "ramify/large/stream_counts.hpp"

#include <cmath>
#include <string>

#include "support/sanitized.hpp"
#include <gtest/gtest.h>

#include "ramify/large/large_orders.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_moments.hpp"

namespace ramify {
namespace {

OrderCount streams_of_order(std::size_t k) {
  return {OrderCount::Of::streams, k};
}

class StreamCountsOf : public ::testing::TestWithParam<std::string> {};

TEST_P(StreamCountsOf, AreTheExactOnesToTwoHundredAndTheirErrorBeyond) {
  const Model model = Model::parse(GetParam());
  for (const Size n : {Size{40}, Size{200}, Size{700}}) {
    const OrderMeans means = build_law(model, n, OrderMeans(n));
    const OrderMoments moments = build_law(model, n, OrderMoments(means, n));
    const StreamCounts counts = stream_counts(model, n);
    for (std::size_t k = 1; k < counts.orders(); ++k) {
      if (means.mean(n, streams_of_order(k)) < 1) break;
      const double deviation = std::sqrt(moments.variance(n, streams_of_order(k)));
      if (deviation < 1e-3) continue;
      const double allowed = n <= 200 ? 1e-9 : 2e-3;
      EXPECT_NEAR(counts.means[k], means.mean(n, streams_of_order(k)), allowed * deviation) << n << ' ' << k;
      EXPECT_NEAR(counts.covariance(k, k) / (deviation * deviation), 1, n <= 200 ? 1e-9 : 1e-2)
          << n << ' ' << k;
    }
  }
}

TEST_P(StreamCountsOf, AreThoseOfLargeOrders) {
  if (test::sanitized) GTEST_SKIP() << "AreTheExactOnesToTwoHundred runs the same code";
  const Model model = Model::parse(GetParam());
  const double n = 1e5;
  const StreamCounts counts = stream_counts(model, static_cast<Size>(n));
  LargeOrders large(model, {n});
  const auto means = large.means(n, OrderCount::Of::streams);
  const auto deviation = [&](std::size_t k) {
    return std::sqrt(large.variance(n, streams_of_order(k)).value);
  };
  for (std::size_t k = 1; k < means.size() && means[k].value > 15; ++k) {
    EXPECT_NEAR(counts.means[k], means[k].value, 2e-2 * deviation(k)) << k;
    for (std::size_t j = 1; j <= k; ++j)
      EXPECT_NEAR(counts.covariance(j, k),
                  large.covariance(n, streams_of_order(j), streams_of_order(k)).value,
                  3e-2 * deviation(j) * deviation(k))
          << j << ' ' << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, StreamCountsOf,
                         ::testing::Values("bst", "catalan", "patricia(0.5)", "patricia(0.295)",
                                           "patricia(0.05)", "dst(0.12)", "beta(0.3,3)", "beta(10,80)",
                                           "beta_multinomial(2,2)", "aldous(-1.8)", "aldous(100)",
                                           "ford(0.9)"),
                         [](const auto& of) {
                           std::string name = of.param;
                           std::erase_if(
                               name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                           return name;
                         });

// A larger child nearer to its parent than some two steps of the grid makes interpolation unstable: errors
// that nobody sees at 1e5 had destroyed the means at 4e8.
TEST(StreamMeansOf, LopsidedSplitsStayRightAtHundredsOfMillions) {
  if (test::sanitized) GTEST_SKIP() << "AreTheExactOnesToTwoHundred runs the same code";
  const Size n = 431'516'064;
  for (const char* text : {"patricia(0.02)", "patricia(0.06)", "patricia(0.0729)", "beta(10,300)"}) {
    const Model model = Model::parse(text);
    const auto large =
        LargeOrders(model, {static_cast<double>(n)}).means(static_cast<double>(n), OrderCount::Of::streams);
    const StreamMeans means = stream_means(model, n);
    for (std::size_t k = 1; k < large.size() && large[k].value > 1; ++k)
      EXPECT_NEAR(means.means[k], large[k].value, 1e-3 * std::sqrt(large[k].value)) << text << ' ' << k;
  }
}

TEST(StreamCountsLaw, MeansAloneAreThoseBesideCovariances) {
  for (const Size n : {Size{150}, Size{5000}}) {
    const Model model = Model::parse("patricia(0.3)");
    const StreamMeans alone = stream_means(model, n);
    const StreamCounts both = stream_counts(model, n);
    EXPECT_EQ(alone.means, both.means);
    EXPECT_EQ(alone.order_tail, both.order_tail);
    EXPECT_DOUBLE_EQ(alone.order_tail.front(), 1);
  }
}

TEST(StreamCountsLaw, WhereThereIsNoneTheReasonIsGiven) {
  EXPECT_TRUE(no_stream_counts(Model::parse("bst"), 1000).empty());
  EXPECT_FALSE(no_stream_counts(Model::parse("ternary(0.2)"), 100).empty());
  EXPECT_FALSE(no_stream_counts(Model::parse("split(0.3)"), 100000).empty());
  EXPECT_TRUE(no_stream_counts(Model::parse("split(0.3)"), 100).empty());
}

}  // namespace
}  // namespace ramify
