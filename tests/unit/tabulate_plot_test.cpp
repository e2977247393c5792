// What the pictures of `law`, `sample` and `measure` show, against hand-counted trees.
#include <cmath>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/measure/horton_plot.hpp"
#include "ramify/tabulate/law_plot.hpp"
#include "ramify/tabulate/law_table.hpp"
#include "ramify/tabulate/sample_plot.hpp"

namespace ramify {
namespace {

LawRequest request_of(const std::string& statistic, std::vector<double> sizes,
                      LawQuantity quantity = LawQuantity::law) {
  return {Model::parse("bst"), LawSubject::parse(statistic), quantity, std::move(sizes)};
}

Plot picture_of(const LawRequest& request) {
  return law_plot(request, law_table(request, {}));
}

TEST(LawPlot, OneSizeIsBars) {
  const Plot plot = picture_of(request_of("strahler", {3}));
  EXPECT_EQ(plot.title, "Horton-Strahler number: order of the root (strahler) of bst");
  ASSERT_EQ(plot.series.size(), 1u);
  EXPECT_EQ(plot.series[0].mark, PlotSeries::Mark::bar);
  ASSERT_EQ(plot.series[0].points.size(), 2u);  // order 2 is the complete tree, one of three as likely
  EXPECT_EQ(plot.series[0].points[0].x, 1);
  EXPECT_NEAR(plot.series[0].points[0].y, 2.0 / 3, 1e-15);
  EXPECT_NEAR(plot.series[0].points[1].y, 1.0 / 3, 1e-15);
}

TEST(LawPlot, SeveralSizesAreCurvesWithoutWhatCannotBeSeen) {
  const Plot plot = picture_of(request_of("height", {10, 1000}));
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[1].label, "n = 1000");
  EXPECT_EQ(plot.series[1].curve.size(), plot.series[1].points.size() + 2);
  EXPECT_EQ(plot.series[1].curve.front().y, 0);
  EXPECT_EQ(plot.series[1].curve.front().x + 1, plot.series[1].points.front().x);
  EXPECT_LT(plot.series[1].points.size(), 40u);
  for (const PlotPoint& point : plot.series[1].points) EXPECT_GT(point.y, 1e-6);
}

TEST(LawPlot, OrdersAreMeanCountsOnALogarithmicAxis) {
  const Plot plot = picture_of(request_of("orders", {3}));
  EXPECT_TRUE(plot.log_y);
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].label, "nodes, n = 3");
  EXPECT_EQ(plot.series[0].points[0].y, 4);
  EXPECT_NEAR(plot.series[1].points[1].y, 4.0 / 3, 1e-14);  // streams of order 1: (n+1)/3
}

TEST(LawPlot, WhatHasNoPictureIsRefused) {
  EXPECT_EQ(test::error_of([] { require_drawable(request_of("height", {10}, LawQuantity::moments)); }),
            "--plot with --moments (laws and the mean counts of orders are drawn): leave one of them out");
  EXPECT_NE(test::error_of([] { require_drawable(request_of("height", {1, 2, 3, 4, 5, 6, 7, 8, 9})); }), "");
  EXPECT_EQ(test::error_of([] { require_drawable(request_of("height", {1, 2, 3, 4, 5, 6, 7, 8})); }), "");
}

Plot histogram_of(const std::string& statistic, Size n, std::uint64_t trees) {
  const TreeBatch batch{Model::parse("bst"), n, 1, 1, true};
  const auto statistics = StatisticSet::parse(std::vector<std::string>{statistic});
  require_histogram(statistics);
  return sample_plot(batch, *statistics.chosen().front(), batch.table(statistics, 0, trees, {}));
}

TEST(SamplePlot, SharesSumToOneBesideTheExactLaw) {
  const Plot plot = histogram_of("strahler", 3, 300);
  ASSERT_EQ(plot.series.size(), 2u);
  const auto& [sampled, exact] = std::pair(plot.series[0], plot.series[1]);
  ASSERT_EQ(sampled.points.size(), 2u);
  EXPECT_EQ(sampled.bar_width, 1);
  EXPECT_NEAR(sampled.points[0].y + sampled.points[1].y, 1, 1e-12);
  EXPECT_NEAR(exact.points[1].y, 1.0 / 3, 1e-15);
  EXPECT_NEAR(sampled.points[1].y, 1.0 / 3, 0.15);
}

TEST(SamplePlot, WideValuesAreGatheredInBarsOfAsManyValues) {
  const Plot plot = histogram_of("path_length", 200, 400);
  double share = 0;
  for (const PlotPoint& point : plot.series[0].points) share += point.y;
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_LE(plot.series[0].points.size(), 61u);
  EXPECT_EQ(plot.series[0].bar_width, std::floor(plot.series[0].bar_width));
  EXPECT_GT(plot.series[0].bar_width, 1);
}

TEST(SamplePlot, TreesWithoutAValueAreCounted) {
  const Plot plot = histogram_of("nodes_mean_ratio", 0, 5);
  EXPECT_TRUE(plot.series.empty());
  EXPECT_TRUE(plot.subtitle.ends_with("; 5 trees have no value")) << plot.subtitle;
}

TEST(SamplePlot, IsOfOneColumn) {
  const auto parse = [](std::vector<std::string> names) { return StatisticSet::parse(names); };
  EXPECT_NE(test::error_of([&] { require_histogram(parse({"height", "strahler"})); }), "");
  EXPECT_NE(test::error_of([&] { require_histogram(parse({"streams"})); }), "");
}

TEST(HortonPlot, GeometricCountsLieOnTheirLine) {
  const Plot plot = horton_plot({{"tree", {}, {27, 9, 3, 1}, {1, 2, 4, 8}, {}, {}, {}}}, 1);
  EXPECT_EQ(plot.title, "Horton diagram of tree");
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].label, "streams: divided by 3 an order");
  EXPECT_EQ(plot.series[1].label, "mean length: times 2 an order");
  EXPECT_EQ(plot.series[0].points[0].x, 1);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_NEAR(plot.series[0].guide[k].y, plot.series[0].points[k].y, 1e-12);
}

// The slope of log 8, log 2, log 1 on the order is (log 1 - log 8)/2: a ratio of sqrt(8).
TEST(HortonPlot, TheLineIsThatOfTheRegression) {
  const Plot plot = horton_plot({{"tree", {}, {8, 2, 1}, {}, {}, {}, {}}}, 0);
  EXPECT_EQ(plot.series[0].label, "streams: divided by 2.828 an order");
  EXPECT_NEAR(plot.series[0].guide[0].y / plot.series[0].guide[1].y, std::sqrt(8.0), 1e-12);
}

TEST(HortonPlot, OfSeveralTreesTheCounts) {
  const MeasuredOrders tree{"a", {}, {3, 1}, {1, 2}, {}, {}, {}};
  EXPECT_EQ(horton_plot({tree, tree}, 1).series.size(), 2u);
  EXPECT_NE(test::error_of([&] { horton_plot(std::vector(9, tree), 1); }), "");
}

}  // namespace
}  // namespace ramify
