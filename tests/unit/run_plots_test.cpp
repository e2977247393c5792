// Which plots a run has, and what is drawn in them, on made-up cells.
#include "ramify/run/run_plots.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/run/exact_check.hpp"

namespace ramify {
namespace {

RunConfig config_of(const std::string& models, const std::string& statistics) {
  return parse_run_config(
      "models = [" + models + "]\nstatistics = [" + statistics + "]\nn = [100, 10000]\nreplicates = 50\n",
      "c.toml");
}

CheckedCell cell_of(std::size_t number, const std::string& model, Size n, const StatisticInfo& statistic,
                    double mean) {
  ColumnSummary summary{statistic};
  summary.mean = mean;
  summary.standard_error = 0.5;
  summary.variance = 4;
  return {number, {model, n, 50, {summary}, {}}, {std::nullopt}};
}

/// Heights of two models, each with its exact curve at a third size.
CheckedRun heights(double small, double large) {
  return {{cell_of(1, "bst", 100, statistic::height, small), cell_of(2, "bst", 10000, statistic::height, 30),
           cell_of(3, "catalan", 100, statistic::height, 31),
           cell_of(4, "catalan", 10000, statistic::height, large)},
          {{"bst", statistic::height, {{100, {14, 4}}, {1000, {23, 5}}, {10000, {32, 6}}}}}};
}

const Plot* find_plot(const std::vector<NamedPlot>& plots, const std::string& stem) {
  for (const auto& [name, plot] : plots)
    if (name == stem) return &plot;
  return nullptr;
}

std::vector<NamedPlot> plots_of(const CheckedRun& run, const ModelLooks& first = {}) {
  const RunConfig config = config_of("\"bst\", \"catalan\"", "\"height\"");
  ModelLooks looks = first;
  looks.add(config);
  return run_plots(run, make_plan(config), looks);
}

TEST(RunPlots, AModelIsOneSeriesOfPointsWithItsExactCurve) {
  const auto plots = plots_of(heights(14, 90));
  const Plot* plot = find_plot(plots, "height");
  ASSERT_NE(plot, nullptr);
  EXPECT_EQ(plot->title, "Longest root-to-leaf path (height)");
  EXPECT_EQ(plot->subtitle,
            "nodes on the path, root and external node counted; points: sampled means, two standard errors; "
            "curves: exact");
  ASSERT_EQ(plot->series.size(), 2u);
  EXPECT_EQ(plot->series[0].label, "bst");
  EXPECT_EQ(plot->series[0].points.size(), 2u);
  EXPECT_EQ(plot->series[0].points[0].error, 1);
  ASSERT_EQ(plot->series[0].curve.size(), 3u);
  EXPECT_EQ(plot->series[0].curve[1].y, 23);
  EXPECT_TRUE(plot->series[1].curve.empty());
  EXPECT_FALSE(plot->log_y);
}

TEST(RunPlots, TheVarianceHasAPlotOfItsOwn) {
  const auto plots = plots_of(heights(14, 90));
  const Plot* plot = find_plot(plots, "height_variance");
  ASSERT_NE(plot, nullptr);
  EXPECT_EQ(plot->series[0].points[0].y, 4);
  EXPECT_EQ(plot->series[0].curve[2].y, 6);
}

TEST(RunPlots, ValuesThatDifferByDecadesLieOnALogarithmicAxis) {
  EXPECT_FALSE(find_plot(plots_of(heights(14, 1399)), "height")->log_y);
  EXPECT_TRUE(find_plot(plots_of(heights(14, 1400)), "height")->log_y);
  const auto plots = plots_of(heights(0, 3500));
  EXPECT_TRUE(find_plot(plots, "height")->log_y);
  EXPECT_TRUE(find_plot(plots, "height")->subtitle.ends_with("values of 0 are not shown"));
}

TEST(RunPlots, OneSizeIsNoPlot) {
  CheckedRun run = heights(14, 90);
  run.cells = {run.cells[0], run.cells[2]};
  EXPECT_TRUE(plots_of(run).empty());
}

TEST(RunPlots, AModelKeepsItsLookFromConfigToConfig) {
  ModelLooks looks;
  looks.add(config_of("\"beta(2,2)\", \"catalan\"", "\"height\""));
  const auto plots = plots_of(heights(14, 90), looks);
  const Plot* plot = find_plot(plots, "height");
  EXPECT_EQ(plot->series[0].look, 2u);  // bst, the third model of the command
  EXPECT_EQ(plot->series[1].look, 1u);
}

/// The run of cells without trees, held against the laws of their models.
CheckedRun checked(const std::string& models, const std::string& sizes, const StatisticInfo& statistic) {
  const Plan plan =
      make_plan(parse_run_config("models = [" + models + "]\nstatistics = [\"" + std::string(statistic.name) +
                                     "\"]\nn = [" + sizes + "]\nreplicates = 5\n",
                                 "c.toml"));
  std::vector<FinishedCell> finished;
  for (std::size_t i = 0; i < plan.cells.size(); ++i)
    finished.push_back({i, cell_of(i, plan.cells[i].model.text(), plan.cells[i].n, statistic, 7).result});
  return check_against_exact_laws(plan, finished, 2);
}

TEST(ExactCurve, GoesFromTheSmallestToTheLargestSizeThroughTheCheckedMeans) {
  const CheckedRun run = checked("\"bst\"", "10, 100, 1000", statistic::height);
  ASSERT_EQ(run.curves.size(), 1u);
  const ExactCurve& curve = run.curves[0];
  EXPECT_EQ(curve.model, "bst");
  EXPECT_GT(curve.points.size(), 80u);
  EXPECT_EQ(curve.points.front().n, 10);
  EXPECT_EQ(curve.points.back().n, 1000);
  EXPECT_EQ(curve.points.front().moments.mean, run.cells[0].checks[0]->exact_mean);
  EXPECT_EQ(curve.points.back().moments.mean, run.cells[2].checks[0]->exact_mean);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    EXPECT_LT(curve.points[i - 1].n, curve.points[i].n);
    EXPECT_LE(curve.points[i - 1].moments.mean, curve.points[i].moments.mean);
  }
}

TEST(ExactCurve, IsMissingWhereNoLawReachesAndForOneSize) {
  EXPECT_TRUE(checked("\"bst\"", "10", statistic::height).curves.empty());
  EXPECT_TRUE(checked("\"bst\"", "10, 100", statistic::width).curves.empty());
  const CheckedRun run = checked("\"split(0.25)\"", "100, 1_000_000", statistic::strahler);
  ASSERT_EQ(run.curves.size(), 1u);
  EXPECT_FALSE(std::isnan(run.curves[0].points.front().moments.mean));
  EXPECT_TRUE(std::isnan(run.curves[0].points.back().moments.mean));
}

TEST(RunPlots, RatiosOfMeanCountsLieOverTheRatiosOfExactMeans) {
  const RunConfig config = config_of("\"bst\"", "\"streams\"");
  ModelLooks looks;
  looks.add(config);
  CheckedRun run{{{1, {"bst", 100, 50, {}, {{}, {}}}, {}}, {2, {"bst", 10000, 50, {}, {{}, {}}}, {}}},
                 {{"bst", {statistic::streams, {0}}, {{100, {101, 0}}, {10000, {10001, 0}}}},
                  {"bst", {statistic::streams, {1}}, {{100, {33.5, 1}}, {10000, {3333.5, 1}}}}}};
  for (CheckedCell& cell : run.cells) cell.result.orders[0].streams_pooled_ratio = {3.01, 0.02};
  const auto plots = run_plots(run, make_plan(config), looks);
  const Plot* plot = find_plot(plots, "streams_ratio_1");
  ASSERT_NE(plot, nullptr);
  EXPECT_EQ(plot->title, "Mean number of streams of order 0 over that of order 1");
  EXPECT_TRUE(plot->subtitle.starts_with("leaf order 0; "));
  EXPECT_DOUBLE_EQ(plot->series[0].points[1].y, 3.01);
  EXPECT_DOUBLE_EQ(plot->series[0].points[1].error, 0.04);
  EXPECT_DOUBLE_EQ(plot->series[0].curve[0].y, 101 / 33.5);
}

}  // namespace
}  // namespace ramify
