// Fits to photographs (H8 to H12): what the source prints, what is exact, and trees that give their own
// numbers back.
#include <array>
#include <cmath>
#include <vector>

#include "support/error_of.hpp"
#include "support/shape_rules.hpp"
#include <gtest/gtest.h>

#include "ramify/shape/photograph_fit.hpp"

namespace ramify {
namespace {

// H11: H0/H = 0.174 and L/h = 0.75, printed h/L (X46).
const Silhouette ginkgo{0.174, 1, 0.75 * (1 - 0.174)};

TEST(Photograph, TheGinkgoAsPrintedAndExactly) {
  const Contraction printed = approximate_contraction(ginkgo);
  EXPECT_NEAR(printed.main, 0.826, 1e-12);
  EXPECT_NEAR(printed.secondary, 0.620, 5e-4);
  const Contraction exact = exact_contraction(ginkgo, 7);
  EXPECT_NEAR(exact.main, 0.9028, 5e-5);
  EXPECT_NEAR(exact.secondary, 0.677, 5e-4);
  // As printed, h/L = 0.75, a branch would be longer than its mother.
  EXPECT_GT(approximate_contraction({0.174, 1, (1 - 0.174) / 0.75}).secondary, 1.1);
}

TEST(Photograph, TheApproximationIsTheLimitOfManyLevels) {
  EXPECT_NEAR(exact_contraction(ginkgo, 400).main, 0.826, 1e-12);
  EXPECT_GT(exact_contraction(ginkgo, 3).main, exact_contraction(ginkgo, 7).main);
}

// A tree of GMT1 without deviations, measured as on a photograph: the exact fit gives its ratios back, and
// h : L = R1 : R2 for every number of levels (X47).
TEST(Photograph, AGrownTreeGivesItsRatiosBack) {
  constexpr double main = 0.85, secondary = 0.6;
  for (const unsigned levels : {1u, 4u, 9u}) {
    ShapeRules rules{test::extent("constant", {0.1}), test::extent("ratios", {10, main, secondary}),
                     test::deviation("roles", {0, 60})};
    rules.main = MainChild::first;
    std::vector<std::uint32_t> word;  // the trunk, and the first lateral followed along its main branches
    for (unsigned k = 0; k < levels; ++k) word.push_back(2);
    word.insert(word.end(), levels, 0);
    word.insert(word.end(), levels - 1, 2);
    word.insert(word.end(), levels, 0);
    const Tree tree(word);
    const Shape shape = test::placed(tree, rules);
    const auto length = [&](std::size_t node) {
      const auto& [start, end, radius] = shape.limbs[node];
      return std::hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
    };
    double lateral = 0;
    for (std::size_t node = 2 * std::size_t{levels}; node < 3 * std::size_t{levels}; ++node)
      lateral += length(node);
    const Silhouette seen{length(0), shape.limbs[levels].end[1], lateral};
    const Contraction fitted = exact_contraction(seen, levels);
    EXPECT_NEAR(fitted.main, main, 1e-10) << levels;
    EXPECT_NEAR(fitted.secondary, secondary, 1e-10) << levels;
  }
}

TEST(Photograph, WhatIsNoSilhouetteIsRefused) {
  for (const Silhouette& tree : {Silhouette{0, 1, 1}, Silhouette{1, 1, 1}, Silhouette{1, 2, -1}})
    EXPECT_NE(test::error_of([&] { exact_contraction(tree, 3); }), "");
  EXPECT_NE(test::error_of([&] { approximate_contraction({1, std::nan(""), 1}); }), "");
}

// H10: the gradient of the log plot is the ratio.
TEST(Photograph, TheGradientOfLogLengthsIsTheRatio) {
  std::vector<double> levels, lengths;
  for (int level = 1; level <= 6; ++level) {
    levels.push_back(level);
    lengths.push_back(40 * std::pow(0.786, level));
  }
  ContractionEstimate exact = contraction_by_level(levels, lengths);
  EXPECT_NEAR(exact.ratio, 0.786, 1e-10);
  EXPECT_NEAR(exact.high - exact.low, 0, 1e-6);
  // With residuals d (+1, -1, -1, +1) in log length at levels 1 to 4 the gradient stays; its standard error
  // is d sqrt(4/2)/sqrt(5), the 90 % point of Student's t with 2 degrees of freedom 1.885618.
  constexpr double d = 0.05;
  const std::array at{1.0, 2.0, 3.0, 4.0}, sign{1.0, -1.0, -1.0, 1.0};
  std::vector<double> noisy;
  for (std::size_t i = 0; i < 4; ++i) noisy.push_back(std::exp(-0.2 * at[i] + d * sign[i]));
  const ContractionEstimate estimate = contraction_by_level(at, noisy);
  const double reach = 1.8856180831641267 * d * std::sqrt(2.0 / 5);
  EXPECT_NEAR(estimate.ratio, std::exp(-0.2), 1e-9);
  EXPECT_NEAR(estimate.low, std::exp(-0.2 - reach), 1e-9);
  EXPECT_NEAR(estimate.high, std::exp(-0.2 + reach), 1e-9);
  EXPECT_NE(test::error_of([] { contraction_by_level(std::array{1.0, 2.0}, std::array{1.0, 0.5}); }), "");
}

/// Aono and Kunii 1984, Table 2b: number and age of the tree, its category, mean angles.
struct Row {
  int tree;
  char age;
  int category;
  AnglesByHeight angles;
};

const std::array<Row, 23> table_2b{
    {{1, 'Y', 1, {28, 30, 28}},  {1, 'A', 1, {30, 31, 20}},   {2, 'A', 3, {53, 73, 45}},
     {2, 'O', 3, {58, 65, 59}},  {3, 'Y', 1, {33, 42, 28}},   {4, 'O', 2, {55, 65, 43}},
     {5, 'O', 1, {71, 86, 61}},  {6, 'Y', 5, {63, 53, 54}},   {6, 'A', 1, {73, 82, 75}},
     {6, 'O', 1, {74, 81, 50}},  {7, 'O', 4, {55, 73, 44}},   {8, 'O', 1, {60, 79, 40}},
     {9, 'O', 1, {51, 57, 46}},  {10, 'A', 1, {50, 70, 23}},  {11, 'O', 3, {44, 62, 40}},
     {12, 'O', 4, {60, 74, 44}}, {13, 'A', 2, {85, 105, 49}}, {13, 'O', 1, {80, 96, 69}},
     {14, 'O', 2, {64, 88, 30}}, {15, 'O', 1, {54, 75, 46}},  {16, 'A', 1, {53, 67, 42}},
     {17, 'O', 1, {60, 74, 51}}, {18, 'O', 2, {56, 61, 42}}}};

// H12: three numbers, two parameters. Of categories 1 and 4 the residual is what the average is off the
// middle, by hand: it falls on all three with weights 2 to 1 to 1.
TEST(Photograph, AnglesOfAllRowsOfTheTable) {
  std::array<int, 6> counts{};
  for (const Row& row : table_2b) {
    ++counts[static_cast<std::size_t>(row.category)];
    const LevelAngles fit = fit_level_angles(row.angles, row.category);
    const auto& [average, bottom, top] = row.angles;
    SCOPED_TRACE(std::to_string(row.tree) + row.age);
    if (row.category == 1 || row.category == 4) {
      const double off = average - (bottom + top) / 2;
      EXPECT_NEAR(fit.highest, bottom + off / 3, 1e-8);
      EXPECT_NEAR(fit.lowest, top + off / 3, 1e-8);
      EXPECT_NEAR(fit.residual, std::abs(off) * std::sqrt(2) / 3, 1e-8);
    }
    if (row.category == 5) {
      EXPECT_NEAR(fit.lowest, (bottom + top) / 2, 1e-8);
      EXPECT_NEAR(fit.highest, fit.lowest + 1.5 * (average - fit.lowest), 1e-8);
    }
    EXPECT_LT(fit.residual, 6.5);
  }
  EXPECT_EQ(counts, (std::array<int, 6>{0, 13, 4, 3, 2, 1}));
}

TEST(Photograph, ARuleGivesItsAnglesBack) {
  for (int category = 1; category <= 5; ++category) {
    const auto at = [&](double tau) { return 20 + 70 * level_share(category, tau, 0.5); };
    double mean = 0;
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) mean += at((i + 0.5) / steps) / steps;
    const LevelAngles fit = fit_level_angles({mean, at(0), at(1)}, category);
    EXPECT_NEAR(fit.highest, 90, 1e-4) << category;
    EXPECT_NEAR(fit.lowest, 20, 1e-4) << category;
    EXPECT_NEAR(fit.residual, 0, 1e-4) << category;
  }
}

}  // namespace
}  // namespace ramify
