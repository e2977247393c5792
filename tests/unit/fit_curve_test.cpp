// The parts of a fit that see a curve and not a tree: crossings, local roots, accepted sets.
#include <cmath>
#include <functional>
#include <vector>

#include "support/seed.hpp"
#include <boost/random/normal_distribution.hpp>
#include <gtest/gtest.h>

#include "ramify/fit/accepted_set.hpp"
#include "ramify/fit/crossings.hpp"
#include "ramify/fit/local_root.hpp"
#include "ramify/fit/ratio_curve.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

constexpr auto stream_ratio = RatioEstimator::streams_mean_ratio;

ResponsePoint point_at(double p, double mean, double error, double half_width = 0) {
  ResponsePoint point{p, 1000, {}};
  point.summary.fill({mean, error, mean - half_width, mean + half_width});
  return point;
}

/// A curve on the grid 0.02, 0.04, ..., 0.5.
std::vector<ResponsePoint> sampled(const std::function<double(double)>& mean, double error,
                                   double half_width = 0) {
  std::vector<ResponsePoint> points;
  for (int i = 1; i <= 25; ++i) points.push_back(point_at(0.02 * i, mean(0.02 * i), error, half_width));
  return points;
}

TEST(FitCrossings, FindsEveryCrossingOfACurve) {
  const auto scan =
      scan_crossings(sampled([](double p) { return 3 + std::sin(20 * p); }, 0.001), stream_ratio, 3.3);
  // sin(20p) = 0.3 at 0.01523, 0.14184, 0.32939, 0.45600; the first lies below the grid.
  ASSERT_EQ(scan.brackets.size(), 3u);
  EXPECT_NEAR(scan.brackets[0].guess, 0.14184, 0.003);
  EXPECT_NEAR(scan.brackets[1].guess, 0.32939, 0.003);
  EXPECT_NEAR(scan.brackets[2].guess, 0.45600, 0.003);
  EXPECT_LT(scan.brackets[0].slope, 0);
  EXPECT_GT(scan.brackets[1].slope, 0);
  EXPECT_TRUE(scan.undecided.empty());
}

TEST(FitCrossings, TakesNoiseForNoCrossing) {
  // Twice within three standard errors below the target, and once beyond: only the last is a crossing.
  std::vector<ResponsePoint> points = sampled([](double) { return 4; }, 0.01);
  points[5] = point_at(points[5].p, 3.08, 0.05);
  points[9] = point_at(points[9].p, 2.90, 0.05);
  EXPECT_EQ(scan_crossings(points, stream_ratio, 3.1).brackets.size(), 2u);
  const auto scan = scan_crossings(std::vector(points.begin(), points.begin() + 8), stream_ratio, 3.1);
  EXPECT_TRUE(scan.brackets.empty());
  ASSERT_EQ(scan.undecided.size(), 1u);
  EXPECT_EQ(scan.undecided[0], points[5].p);
}

TEST(FitCrossings, ALoneUndecidedPointBetweenOppositeSidesIsACrossing) {
  std::vector<ResponsePoint> points{point_at(0.1, 4, 0.01), point_at(0.2, 3.01, 0.01),
                                    point_at(0.3, 2, 0.01)};
  const auto scan = scan_crossings(points, stream_ratio, 3);
  ASSERT_EQ(scan.brackets.size(), 1u);
  EXPECT_EQ(scan.brackets[0].low, 0.1);
  EXPECT_EQ(scan.brackets[0].high, 0.3);
  EXPECT_TRUE(scan.undecided.empty());
}

TEST(FitCrossings, SuspectsAHumpBetweenPoints) {
  // 3 - 400 (p - 0.21)^2 tops out at 3 between the points 0.20 and 0.22.
  const auto hump = [](double p) { return 3 - 400 * (p - 0.21) * (p - 0.21); };
  const auto scan = scan_crossings(sampled(hump, 1e-4), stream_ratio, 2.98);
  EXPECT_TRUE(scan.brackets.empty());
  ASSERT_FALSE(scan.vertices.empty());
  EXPECT_NEAR(scan.vertices.front(), 0.21, 0.002);
  EXPECT_TRUE(scan_crossings(sampled(hump, 1e-4), stream_ratio, 3.05).vertices.empty());
}

TEST(FitCrossings, AFlatCurveDecidesNothing) {
  EXPECT_FALSE(scan_crossings(sampled([](double) { return 3; }, 0), stream_ratio, 3).any_decided);
}

TEST(FitLocalRoot, SolvesAParabolaExactly) {
  // 4.35 - 30 (p - 0.167) + 80 (p - 0.167)^2, whose other root is at 0.542.
  std::vector<CurveSample> samples;
  for (const double p : {0.15, 0.155, 0.16, 0.165, 0.17, 0.175, 0.18}) {
    const double distance = p - 0.167;
    samples.push_back({p, 4.35 - 30 * distance + 80 * distance * distance, 0.01});
  }
  const LocalRoot root = solve_local_root(samples, 4.35, 0.162, -35);
  ASSERT_TRUE(root.converged);
  EXPECT_NEAR(root.p, 0.167, 1e-10);
  EXPECT_NEAR(root.slope, -30, 1e-6);
  EXPECT_GT(root.misfit, 0.999);
}

TEST(FitLocalRoot, StandardErrorIsThatOfRepetition) {
  // 4,000 noisy repetitions: (p* - truth) / standard_error has variance 1.
  Stream stream({test::seed_of("fit local root"), 0}, 0);
  boost::random::normal_distribution<double> normal;
  double sum = 0, squares = 0, misfits = 0;
  constexpr int repetitions = 4000;
  for (int i = 0; i < repetitions; ++i) {
    std::vector<CurveSample> samples;
    for (const double p : {0.15, 0.155, 0.16, 0.165, 0.17, 0.175, 0.18})
      samples.push_back(
          {p, 4.35 - 30 * (p - 0.167) + 80 * (p - 0.167) * (p - 0.167) + 0.01 * normal(stream), 0.01});
    const LocalRoot root = solve_local_root(samples, 4.35, 0.162, -35);
    ASSERT_TRUE(root.converged);
    const double z = (root.p - 0.167) / root.standard_error;
    sum += z;
    squares += z * z;
    misfits += root.misfit;
  }
  EXPECT_NEAR(sum / repetitions, 0, 5 / std::sqrt(repetitions));
  EXPECT_NEAR(squares / repetitions, 1, 5 * std::sqrt(2.0 / repetitions));
  EXPECT_NEAR(misfits / repetitions, 0.5, 5 * std::sqrt(1.0 / 12 / repetitions));
}

TEST(FitLocalRoot, SaysWhereAParabolaDoesNotFit) {
  std::vector<CurveSample> samples;
  for (const double p : {0.1, 0.12, 0.14, 0.16, 0.18, 0.2, 0.22})
    samples.push_back({p, 4 + std::sin(40 * p), 0.01});
  EXPECT_LT(solve_local_root(samples, 4, 0.157, -40).misfit, 1e-6);
}

TEST(FitAcceptedSet, IsWhereTheBandContainsTheRatio) {
  // Mean 5 - 10p, band +-0.5: 3 is accepted for 10p in [1.5, 2.5].
  const auto band = sampled([](double p) { return 5 - 10 * p; }, 0.01, 0.5);
  const auto pieces = accepted_set(band, stream_ratio, 3);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].low, 0.15, 1e-10);
  EXPECT_NEAR(pieces[0].high, 0.25, 1e-10);
  EXPECT_TRUE(accepted_set(band, stream_ratio, 9).empty());
}

TEST(FitAcceptedSet, MayBeAUnion) {
  // A hollow at 0.25: 25 (p - 0.25)^2 in [0.25, 0.75] is [0.0768, 0.15] and its mirror image.
  const auto band = sampled([](double p) { return 3 + 25 * (p - 0.25) * (p - 0.25); }, 0.01, 0.25);
  const auto pieces = accepted_set(band, stream_ratio, 3.5);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0].low, 0.25 - std::sqrt(0.03), 2e-3);
  EXPECT_NEAR(pieces[0].high, 0.15, 2e-3);
  EXPECT_NEAR(pieces[1].low, 0.35, 2e-3);
  EXPECT_NEAR(pieces[1].high, 0.25 + std::sqrt(0.03), 2e-3);
}

TEST(FitCurve, MergeKeepsTheBetterPointInOrder) {
  RatioCurve curve;
  const std::vector first{point_at(0.3, 3, 0.1), point_at(0.1, 5, 0.1)};
  curve.merge(first);
  ResponsePoint better = point_at(0.3, 3.05, 0.01);
  better.trees = 4000;
  curve.merge(std::vector{better, point_at(0.2, 4, 0.1)});
  curve.merge(first);
  ASSERT_EQ(curve.points().size(), 3u);
  EXPECT_EQ(curve.points()[1].p, 0.2);
  EXPECT_EQ(curve.find(0.3)->trees, 4000u);
  EXPECT_EQ(curve.find(0.25), nullptr);
}

TEST(FitResponse, SummaryOfKnownNumbers) {
  std::vector<RatioValues> rows;
  for (int i = 40; i >= 0; --i) rows.push_back(RatioValues{static_cast<double>(i), 1, 1, 1, 1, 1});
  const auto summary = summarise(rows);
  EXPECT_DOUBLE_EQ(summary[0].mean, 20);
  EXPECT_NEAR(summary[0].standard_error, std::sqrt(143.5 / 41), 1e-12);
  EXPECT_DOUBLE_EQ(summary[0].low, 1);
  EXPECT_DOUBLE_EQ(summary[0].high, 39);
  EXPECT_EQ(summary[1].standard_error, 0);
}

}  // namespace
}  // namespace ramify
