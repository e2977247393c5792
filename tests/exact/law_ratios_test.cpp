// Ratios of expected counts as functions of p, by law.
#include "ramify/fit/law_ratios.hpp"

#include <array>
#include <cmath>
#include <string>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/model/model.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

constexpr std::array law_estimators{LawEstimator::streams_pooled_ratio,
                                    LawEstimator::streams_regression_of_means};

// The definitions, literally, from the exact means of all orders.
TEST(LawRatio, IsOfTheExpectedCounts) {
  constexpr Size n = 120;
  const Model model = Model::parse("patricia(0.3)");
  const OrderMeans exact = build_law(model, n, OrderMeans(n));
  const auto orders = exact.strahler().pmf(n);
  const std::vector<double> means = exact.streams(n);
  double all = 0, above = 0, w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0, tail = 1;
  for (std::size_t k = 0; k < means.size(); ++k) {
    all += means[k];
    if (k > 0) above += means[k];
    const double x = static_cast<double>(k), y = tail > 0 ? std::log(means[k]) : 0;
    w += tail, wx += tail * x, wy += tail * y, wxx += tail * x * x, wxy += tail * x * y;
    tail = std::max(0.0, tail - orders[k]);
  }
  const StreamMeans counts = stream_means(model, n);
  EXPECT_NEAR(law_ratio(LawEstimator::streams_pooled_ratio, counts), (all - 1) / above, 1e-10);
  EXPECT_NEAR(law_ratio(LawEstimator::streams_regression_of_means, counts),
              std::exp(-(w * wxy - wx * wy) / (w * wxx - wx * wx)), 1e-8);
}

// Of the pooled ratio, which rests on orders of many streams: the delta method is right to a few per cent.
TEST(LawRatio, ScattersAsTheDeltaMethodSays) {
  constexpr Size n = 1000;
  constexpr std::uint64_t trees = 4000;
  const Model model = Model::parse("patricia(0.3)");
  const StreamCounts counts = stream_counts(model, n);
  const auto sampler = make_tree_sampler({model, {orders_and_height, true}, n, &test::uninterrupted});
  test::SampleMean square;
  const double mean = law_ratio(LawEstimator::streams_pooled_ratio, counts);
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < trees; ++replicate) {
    sampler->sample(n, {test::seed_of("delta method"), n}, replicate, measures);
    const auto streams = measures.streams.begin();
    const double ratio = pooled_over_orders({streams, streams + measures.strahler + 1});
    square.add((ratio - mean) * (ratio - mean));
  }
  const double deviation = law_ratio_deviation(LawEstimator::streams_pooled_ratio, counts);
  EXPECT_NEAR(std::sqrt(square.mean()) / deviation, 1, 0.06);
}

TEST(LawRatios, RootsHaveTheObservedRatio) {
  std::vector<double> grid;
  for (double p = 0.02; p < 0.5; p *= 1.05) grid.push_back(p);
  grid.push_back(0.5);
  const LawRatios laws(Patricia::info(), 5000, grid, 2, test::uninterrupted);
  for (const LawEstimator estimator : law_estimators) {
    const auto [low, high] = laws.range(estimator);
    EXPECT_LT(low, high);
    const auto roots = laws.roots(estimator, 3.4);
    ASSERT_FALSE(roots.empty());
    for (const LawRoot& root : roots) {
      EXPECT_NEAR(laws.value(estimator, root.p), 3.4, 1e-9);
      EXPECT_GT(root.deviation, 0);
    }
    EXPECT_TRUE(laws.roots(estimator, high + 0.1).empty());
  }
}

}  // namespace
}  // namespace ramify
