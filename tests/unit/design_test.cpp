// Designs have what was wanted, all of them are found, and what no tree has is refused with what there is.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/sanitized.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/core/number.hpp"
#include "ramify/design/depth_curve.hpp"
#include "ramify/design/depth_height_table.hpp"
#include "ramify/design/height_map.hpp"
#include "ramify/design/moment_table.hpp"
#include "ramify/design/pooled_ratio.hpp"
#include "ramify/design/ratio_designs.hpp"
#include "ramify/theory/constants.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/height_constant.hpp"

namespace ramify {
namespace {

const Cancellation never;
const ScanEffort effort{2, &never};

double depth_of(double a, double b) {
  return beta_depth({a, b})->value;
}

double height_of(double a, double b) {
  return beta_height({a, b})->value;
}

std::vector<BetaSplit> designs(double depth, double height) {
  return DepthCurve(depth, effort).with_height(height);
}

/// The heights of one depth as the catalogue's H6 walks through them: for a mean of the split, a + b by
/// bisection.
std::vector<double> heights_by_mean(double depth, double lowest_mean, double step) {
  std::vector<double> heights;
  for (double mean = 0.5; mean > lowest_mean; mean -= step) {
    double low = 1e-4, high = 1e6;
    while (high / low > 1 + 1e-13) {
      const double sum = std::sqrt(low * high);
      (depth_of(mean * sum, (1 - mean) * sum) > depth ? low : high) = sum;
    }
    heights.push_back(height_of(mean * low, (1 - mean) * low));
  }
  return heights;
}

TEST(ScannedCurve, FindsEveryCrossingAndTheExtremaBetweenPoints) {
  // Roots -1, 0, 1; extrema at -+1/sqrt(3), which no grid point is.
  const auto cubic = [](double x) { return x * x * x - x; };
  const ScannedCurve curve(cubic, {-2, -1.4, -0.7, -0.2, 0.3, 0.9, 1.5}, effort);
  const auto roots = curve.solutions(0);
  ASSERT_EQ(roots.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(roots[i], static_cast<double>(i) - 1, 1e-14);
  const double top = 2 / std::sqrt(27);
  EXPECT_EQ(curve.solutions(top - 1e-6).size(), 3u) << "two of them in one cell of the grid";
  EXPECT_EQ(curve.solutions(top + 1e-6).size(), 1u);
  EXPECT_EQ(curve.solutions(top).size(), 2u) << "touched from below, and crossed";
  EXPECT_TRUE(curve.solutions(4).empty());
  EXPECT_EQ(curve.highest().y, cubic(1.5));
  EXPECT_EQ(curve.lowest().y, cubic(-2));
}

TEST(ScannedCurve, IsWithoutThePointsThatHaveNoValue) {
  const ScannedCurve curve([](double x) { return std::sqrt(x); }, {-2, -1, 1, 4, 9}, effort);
  EXPECT_EQ(curve.points().size(), 3u);
  EXPECT_NEAR(curve.solutions(1.5).at(0), 2.25, 1e-14);
  const ScannedCurve flat([](double) { return 3.0; }, {0, 1, 2, 3}, effort);
  EXPECT_EQ(flat.solutions(3), (std::vector<double>{0, 3}));
}

TEST(DepthCurve, GivesBackTreesThatAreKnown) {
  const std::vector<BetaSplit> known{{1, 1}, {1, 2}, {10, 80}, {0.3, 0.7}, {0.01, 5}, {2, 9}, {100, 140}};
  for (const auto& [a, b] : known) {
    const auto found = designs(depth_of(a, b), height_of(a, b));
    EXPECT_TRUE(std::ranges::any_of(found,
                                    [a = a, b = b](const BetaSplit& split) {
                                      return std::abs(split.a / a - 1) < 1e-6 &&
                                             std::abs(split.b / b - 1) < 1e-6;
                                    }))
        << a << ", " << b;
  }
  EXPECT_EQ(designs(2, height_of(1, 1)), (std::vector<BetaSplit>{{1, 1}, {1, 2}}));
}

// The unordered split is one: R(a,a) = R(a,a+1) and so are depth and height.
TEST(DepthCurve, FindsBothBetaTreesOfOneUnorderedSplit) {
  for (const double a : {0.1, 0.5, 3.0, 40.0}) {
    const auto found = designs(depth_of(a, a), height_of(a, a));
    ASSERT_GE(found.size(), 2u) << a;
    EXPECT_NEAR(found[0].b / a, 1, 1e-9);
    EXPECT_TRUE(std::ranges::any_of(
        found, [a](const BetaSplit& split) { return std::abs(split.b / (a + 1) - 1) < 1e-9; }));
  }
}

TEST(DepthCurve, DesignsHaveTheConstantsThatWereWanted) {
  if (test::sanitized) GTEST_SKIP() << "GivesBackTreesThatAreKnown runs the same code";
  const std::pair<double, double> wanted[] = {{1.5, 2.1}, {1.75, 3.36}, {2, 4.4},   {2, 4.3085}, {3, 8},
                                              {5, 17},    {10, 40},     {100, 320}, {1e4, 4e4}};
  for (const auto& [depth, height] : wanted) {
    const auto found = designs(depth, height);
    EXPECT_FALSE(found.empty()) << depth << ", " << height;
    for (const BetaSplit& split : found) {
      const Model model = Model::parse(fmt::format("beta({},{})", split.a, split.b));
      EXPECT_NEAR(depth_constant(model)->value / depth, 1, 1e-9);
      EXPECT_NEAR(height_constant(model)->value / height, 1, 1e-9);
      EXPECT_LE(split.a, split.b);
    }
  }
}

TEST(DepthCurve, HasAsManySolutionsAsASearchOverMeans) {
  if (test::sanitized) GTEST_SKIP() << "GivesBackTreesThatAreKnown runs the same code";
  for (const auto& [depth, end] : {std::pair{1.6, 0.3180}, {2.0, 0.2000}, {3.0, 0.1040}}) {
    const auto heights = heights_by_mean(depth, end, 0.004);
    const DepthCurve curve(depth, effort);
    const double low = std::ranges::min(heights), high = std::ranges::max(heights);
    for (const double share : {0.03, 0.21, 0.4, 0.63, 0.81, 0.95}) {
      const double height = std::lerp(low, high, share);
      std::size_t crossings = 0;
      for (std::size_t i = 1; i < heights.size(); ++i)
        if ((heights[i - 1] > height) != (heights[i] > height)) ++crossings;
      // Beyond the search's last mean the curve goes on to its end.
      if ((heights.back() > height) != (curve.end_height() > height)) ++crossings;
      EXPECT_EQ(curve.with_height(height).size(), crossings) << depth << ", " << height;
    }
  }
}

TEST(DepthCurve, RangesFromExtremaToTheSplitOfOneFraction) {
  const HeightRange two = DepthCurve(2, effort).heights();
  EXPECT_NEAR(two.lowest.height, 4.307540352, 1e-8);
  EXPECT_NEAR(two.highest.height, 4.497726351, 1e-8);
  ASSERT_TRUE(two.lowest.split && two.highest.split);
  EXPECT_NEAR(height_of(two.lowest.split->a, two.lowest.split->b), two.lowest.height, 1e-12);
  EXPECT_NEAR(depth_of(two.highest.split->a, two.highest.split->b), 2, 1e-12);

  const DepthCurve slight(1.45, effort);
  const double x = slight.end_fraction();
  EXPECT_NEAR(-x * std::log(x) - (1 - x) * std::log1p(-x), 1 / 1.45, 1e-14);
  EXPECT_NEAR(slight.end_height(), -1 / std::log1p(-x), 1e-14);
  EXPECT_FALSE(slight.heights().lowest.split) << "a limit";
  EXPECT_EQ(slight.heights().lowest.height, slight.end_height());
  EXPECT_NEAR(slight.lowest_found(), slight.end_height(), 1e-7);
}

TEST(DepthCurve, OfADepthThatNoBetaTreeHasIsRefused) {
  const auto refusal = [](double depth) { return test::error_of([=] { DepthCurve(depth, effort); }); };
  EXPECT_NE(refusal(1).find("above 1/log 2"), std::string::npos);
  EXPECT_NE(refusal(1 / std::numbers::ln2).find("above 1/log 2"), std::string::npos);
  EXPECT_NE(refusal(1.44269504100).find("take 1.4426950414093056 or more"), std::string::npos);
  EXPECT_NE(refusal(1e9).find("up to 1e+08"), std::string::npos);
  EXPECT_EQ(refusal(1.4426950414093056), "");
  EXPECT_EQ(refusal(1e8), "");
}

/// The number behind "take --height ".
double advised(const std::string& refusal) {
  const std::string mark = "take --height ";
  const auto begin = refusal.find(mark) + mark.size();
  return parse_real(refusal.substr(begin, refusal.find(',', begin) - begin)).value();
}

TEST(DepthHeightTable, RefusesWhatNoTreeHasAndAdvisesWhatOneHas) {
  for (const double depth : {1.4427, 1.45, 2.0, 6.0}) {
    const DepthCurve curve(depth, effort);
    for (const double height :
         {1.0, 0.999 * curve.lowest_found(), 1.001 * curve.heights().highest.height, 1e12}) {
      const std::string refusal = test::error_of([&] { depth_height_table(curve, height); });
      EXPECT_NE(refusal.find("no such tree: for this depth the feasible heights are from "),
                std::string::npos)
          << refusal;
      EXPECT_GE(depth_height_table(curve, advised(refusal)).rows(), 1u) << refusal;
    }
  }
  const DepthCurve slight(1.45, effort);
  const double between = (slight.end_height() + slight.lowest_found()) / 2;
  const std::string refusal = test::error_of([&] { depth_height_table(slight, between); });
  EXPECT_NE(refusal.find("it takes a or b above 1e9"), std::string::npos) << refusal;
}

TEST(DepthHeightTable, SaysWhatTheDesignsHave) {
  const Table table = depth_height_table({2, effort}, height_of(1, 1));
  EXPECT_EQ(table.columns(), (std::vector<std::string>{"model", "a", "b", "depth", "height"}));
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(to_text(table.at(0, "model")), "beta(1,1)");
  EXPECT_EQ(table.number(1, "b"), 2);
  EXPECT_EQ(table.number(1, "depth"), 2);
  EXPECT_NEAR(table.number(1, "height"), 4.311070407001, 1e-12);
  const Table curve = depth_curve_table({2, effort});
  EXPECT_GT(curve.rows(), 40u);
  for (std::size_t row = 0; row < curve.rows(); ++row) EXPECT_NEAR(curve.number(row, "depth"), 2, 1e-11);
}

TEST(HeightMap, HoldsTheHeightsOfEachDepth) {
  const Table map = height_map({1.45, 2, 8}, effort);
  ASSERT_EQ(map.rows(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_LE(map.number(row, "lowest_height"), map.number(row, "symmetric_height"));
    EXPECT_GE(map.number(row, "highest_height"), map.number(row, "symmetric_height"));
  }
  EXPECT_NEAR(map.number(1, "symmetric_height"), height_of(1, 1), 1e-12);
  EXPECT_TRUE(to_text(map.at(0, "lowest_model")).starts_with("split(0.458239123915")) << "a limit";
  EXPECT_TRUE(to_text(map.at(1, "lowest_model")).starts_with("beta(0.92220"));
  const Plot plot = height_map_plot(map);
  ASSERT_EQ(plot.series.size(), 3u);
  EXPECT_EQ(plot.series[1].curve.size(), 3u);
  EXPECT_NEAR(plot.series[1].curve[1].y, height_of(1, 1) / 2, 1e-12);
}

TEST(Moments, AreThoseOfTheSplit) {
  for (const auto& [mean, variance] : {std::pair{0.5, 1.0 / 12}, {0.3, 0.02}, {0.9, 0.08}, {0.01, 1e-8}}) {
    const auto [a, b] = split_of_moments(mean, variance);
    EXPECT_NEAR(a / (a + b) / mean, 1, 1e-11);
    EXPECT_NEAR(a * b / ((a + b) * (a + b) * (a + b + 1)) / variance, 1, 1e-9);
  }
  EXPECT_EQ(split_of_moments(0.5, 1.0 / 12), (BetaSplit{1, 1}));
  const auto refusal = [](double mean, double variance) {
    return test::error_of([=] { split_of_moments(mean, variance); });
  };
  EXPECT_NE(refusal(0.3, 0.21).find("below m (1-m) = 0.21"), std::string::npos);
  EXPECT_NE(refusal(0.3, 0.5).find("below m (1-m) = 0.21"), std::string::npos);
  EXPECT_NE(refusal(0.3, 0).find("split(0.3) has none"), std::string::npos);
  EXPECT_NE(refusal(0, 0.1).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(refusal(1, 0.1).find("between 0 and 1"), std::string::npos);
  EXPECT_NE(refusal(0.3, 1e-12).find("take a larger variance"), std::string::npos);
  EXPECT_NE(refusal(1e-10, 1e-11).find("take a smaller variance"), std::string::npos);
}

TEST(PooledRatio, IsThatOfExpectedCounts) {
  const auto ratio = [](const char* model, Size n) {
    return expected_pooled_ratio(Model::parse(model), n, never);
  };
  EXPECT_DOUBLE_EQ(ratio("patricia(0.2)", 1), 2);
  EXPECT_DOUBLE_EQ(ratio("beta(2,3)", 2), 3);
  // A third of the trees of three nodes have streams 4, 2, 1, the others 4, 1: (6 + 2 * 4) / (3 + 2 * 1).
  EXPECT_DOUBLE_EQ(ratio("bst", 3), 2.8);
  EXPECT_DOUBLE_EQ(ratio("complete", 7), 14.0 / 7);
  // On both sides of the seam between the exact laws and those on a grid.
  EXPECT_NEAR(ratio("bst", 2048), ratio("bst", 2100), 1e-3);
}

TEST(RatioDesigns, HaveTheLimitingRatioThatWasWanted) {
  if (test::sanitized) GTEST_SKIP() << "HaveTheRatioOfTheirSizeThatWasWanted runs the same code";
  const Table table = limiting_ratio_designs(3, effort);
  ASSERT_GE(table.rows(), 4u);
  EXPECT_EQ(to_text(table.at(0, "model")), "patricia(1/3)");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Model model = Model::parse(to_text(table.at(row, "model")));
    const auto known = constants(model);
    const auto ratio = std::ranges::find(known, "horton_ratio", &Constant::name);
    ASSERT_NE(ratio, known.end());
    EXPECT_NEAR(ratio->value, 3, 1e-8) << model.text();
  }
  EXPECT_NE(test::error_of([] { limiting_ratio_designs(1.9, effort); }).find("2 or more"), std::string::npos);
}

TEST(RatioDesigns, HaveTheRatioOfTheirSizeThatWasWanted) {
  const Table table = finite_ratio_designs(3.61, 25, effort);
  bool has_dst = false, has_beta = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string model = to_text(table.at(row, "model"));
    has_dst = has_dst || model.starts_with("dst(");
    has_beta = has_beta || model.starts_with("beta(");
    EXPECT_NEAR(expected_pooled_ratio(Model::parse(model), 25, never), 3.61, 1e-9) << model;
  }
  EXPECT_TRUE(has_dst && has_beta);
  EXPECT_NE(
      test::error_of([] { finite_ratio_designs(30, 12, effort); }).find("streams pooled over orders have"),
      std::string::npos);
  EXPECT_NE(test::error_of([] { finite_ratio_designs(3, 2, effort); }).find("one ratio"), std::string::npos);
}

}  // namespace
}  // namespace ramify
