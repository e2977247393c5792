// Horton's ratios of measured trees: estimators, ranges of orders, errors, what is named as outlying.
#include "ramify/horton/horton_laws.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "ramify/format/order_counts.hpp"
#include "ramify/horton/scatter.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

using Values = std::vector<double>;

double regression_of(const std::string& file) {
  const std::string text = read_text_file(std::filesystem::path(RAMIFY_SOURCE_DIR) / "data" / file);
  const OrderCounts counts = read_order_counts(SourceText(text, file)).front();
  return ratio_of(RatioKind::regression, Values(counts.counts.rbegin(), counts.counts.rend()));
}

MeasuredOrders measured(std::vector<std::uint64_t> streams, Values radii = {}) {
  return {"x", {}, std::move(streams), {}, std::move(radii), {}, {}};
}

HortonLaws laws_of(const MeasuredOrders& tree, std::uint64_t trees = 400) {
  const HortonOptions options{{&find_family("bst")}, {trees, 1996, 2}};
  return horton_laws(std::span(&tree, 1), options, {}).front();
}

const HortonRatio& ratio_named(const HortonLaws& laws, std::string_view quantity,
                               std::string_view estimator) {
  for (const HortonRatio& ratio : laws.ratios)
    if (ratio.quantity == quantity && ratio.estimator == estimator) return ratio;
  throw std::out_of_range(std::string(estimator));
}

// Kassab et al. 1993 print 3.50, 3.51 and 3.57, Huang et al. 1996 3.33 of the vein; of the artery and the
// airways the values of the tables shipped.
TEST(HortonLaws, RegressionsArePublishedOnes) {
  EXPECT_NEAR(regression_of("coronary_rca.csv"), 3.50, 0.005);
  EXPECT_NEAR(regression_of("coronary_lad.csv"), 3.51, 0.005);
  EXPECT_NEAR(regression_of("coronary_lcx.csv"), 3.57, 0.005);
  EXPECT_NEAR(regression_of("pulmonary_vein.csv"), 3.33, 0.005);
  EXPECT_NEAR(regression_of("pulmonary_artery.csv"), 3.354, 0.0005);
  EXPECT_NEAR(regression_of("airway_ct.csv"), 2.454, 0.0005);
}

TEST(HortonLaws, EstimatorsAreTheirDefinitions) {
  const Values rising{1, 3, 8};
  EXPECT_DOUBLE_EQ(ratio_of(RatioKind::mean_ratio, rising), (3 + 8.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(ratio_of(RatioKind::pooled_ratio, rising), 11.0 / 4);
  EXPECT_DOUBLE_EQ(ratio_of(RatioKind::geometric, rising), std::sqrt(8));
  EXPECT_DOUBLE_EQ(ratio_of(RatioKind::regression, rising), std::sqrt(8));  // of three the ends decide
  EXPECT_TRUE(std::isnan(ratio_of(RatioKind::pooled_ratio, Values{1})));
}

TEST(HortonLaws, SlopesOfTheGeometricAndPooledRatio) {
  const auto geometric = log_slopes(RatioKind::geometric, Values{1, 3, 8});
  EXPECT_NEAR(geometric[0], -0.5, 1e-8);
  EXPECT_NEAR(geometric[1], 0, 1e-8);
  EXPECT_NEAR(geometric[2], 0.5, 1e-8);
  const auto pooled = log_slopes(RatioKind::pooled_ratio, Values{1, 3, 8});  // log 11 - log 4
  EXPECT_NEAR(pooled[0], -1.0 / 4, 1e-7);
  EXPECT_NEAR(pooled[1], 3.0 / 11 - 3.0 / 4, 1e-7);
  EXPECT_NEAR(pooled[2], 8.0 / 11, 1e-7);
}

TEST(HortonLaws, RangesOfOrders) {
  const Values counts{100, 30, 9, 2, 1};
  EXPECT_EQ(orders_of(OrderRange::all, counts), (OrderSpan{0, 4}));
  EXPECT_EQ(orders_of(OrderRange::below_top, counts), (OrderSpan{0, 3}));
  EXPECT_EQ(orders_of(OrderRange::inner, counts), (OrderSpan{1, 3}));
  EXPECT_EQ(orders_of(OrderRange::dense, counts), (OrderSpan{0, 1}));
  EXPECT_FALSE(orders_of(OrderRange::dense, Values{29, 9}));
  EXPECT_FALSE(orders_of(OrderRange::inner, Values{9, 3, 1}));
}

TEST(HortonLaws, ScatterIsThatOfTheLine) {
  EXPECT_NEAR(scatter_error(RatioKind::regression, Values{1, 2, 4, 8}), 0, 1e-9);
  // log x = 0, 0, 1, 1: slope 0.4, residuals 0.1, -0.3, 0.3, -0.1: 0.2/2 over 5.
  const double e = std::exp(1);
  EXPECT_NEAR(scatter_error(RatioKind::regression, Values{1, 1, e, e}), std::sqrt(0.1 / 5), 1e-7);
  EXPECT_NEAR(scatter_error(RatioKind::geometric, Values{1, 1, e, e}), std::sqrt(0.1 * 2 / 9), 1e-7);
  EXPECT_TRUE(std::isnan(scatter_error(RatioKind::regression, Values{1, 2})));
}

TEST(HortonLaws, AValueOffTheLineIsNamed) {
  EXPECT_EQ(off_the_line(Values{1, 2.1, 3.9, 24, 16.2, 31, 65}), std::vector<std::size_t>{3});
  EXPECT_TRUE(off_the_line(Values{1, 2.1, 3.9, 8.3, 16.2, 31, 65}).empty());
  EXPECT_TRUE(off_the_line(Values{1, 2, 40, 8}).empty());  // too few to say which
}

TEST(HortonLaws, LawAndTreesAgreeWhereStreamsAreMany) {
  const Values counts{1868, 622, 207, 69, 23, 8, 2, 1};
  const Cancellation cancellation;
  const ModelRatios ratios(Model::parse("bst"), counts, {2000, 1996, 2}, cancellation);
  for (const RatioKind kind : ratio_kinds) {
    const ModelRatio trees = ratios.by_trees(kind, OrderRange::dense), law = ratios.by_law(kind, {0, 3});
    EXPECT_NEAR(trees.deviation, law.deviation, 0.1 * law.deviation) << name_of(kind);
    EXPECT_NEAR(trees.mean, law.mean, 0.3 * law.deviation) << name_of(kind);
    // A near mistake, independent counts of Poisson's law, is farther off.
    if (kind != RatioKind::geometric) continue;
    EXPECT_GT(std::abs(law.mean * std::sqrt(1 / 69.0) / 3 - law.deviation), 0.1 * law.deviation);
  }
}

TEST(HortonLaws, AnOrderThatTheModelDoesNotHaveIsNamed) {
  EXPECT_TRUE(ratio_named(laws_of(measured({1868, 622, 207, 69, 23, 8, 2, 1})), "R_B", "regression")
                  .outlying.empty());
  const HortonLaws odd = laws_of(measured({1868, 622, 270, 69, 23, 8, 2, 1}));
  EXPECT_EQ(ratio_named(odd, "R_B", "regression").outlying, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(ratio_named(odd, "R_B", "regression_inner").outlying, (std::vector<std::size_t>{1, 2}));
}

TEST(HortonLaws, BiasIsFromTheLimitingRatio) {
  const HortonLaws laws = laws_of(measured({1868, 622, 207, 69, 23, 8, 2, 1}));
  EXPECT_EQ(laws.model, "bst");
  EXPECT_EQ(laws.reference_name, "limit");
  EXPECT_NEAR(laws.reference, 3.04382786183867, 1e-9);
  const HortonRatio& pooled = ratio_named(laws, "R_B", "pooled_ratio");
  EXPECT_EQ(pooled.error_from, ErrorSource::trees);
  // E M_1 = (n+1)/3 and all higher ratios are near the limit R: 1 + 3 (1 - 1/R) - R.
  EXPECT_NEAR(pooled.bias, -0.03, 0.01);
  EXPECT_EQ(ratio_named(laws, "R_B", "pooled_ratio_dense").error_from, ErrorSource::law);
}

TEST(HortonLaws, ATooSmallTreeHasErrorsFromItsScatterAndSaysSo) {
  const HortonLaws laws = laws_of(measured({9, 3, 1}));
  const HortonRatio& ratio = ratio_named(laws, "R_B", "regression");
  EXPECT_EQ(ratio.error_from, ErrorSource::scatter);
  EXPECT_NEAR(ratio.standard_error, 0, 1e-8);
  EXPECT_NE(ratio.note.find("9 tips, 3 orders are too few"), std::string::npos) << ratio.note;
  EXPECT_TRUE(laws.model.empty());
}

TEST(HortonLaws, CountsOfNoBinaryTreeHaveNoModel) {
  const HortonLaws laws = laws_of(measured({100, 60, 10, 1}));
  EXPECT_NE(ratio_named(laws, "R_B", "regression").note.find("no binary tree has 60 streams above 100"),
            std::string::npos);
}

TEST(HortonLaws, MurraysExponentByRatios) {
  const HortonLaws laws = laws_of(measured({16, 8, 4, 2}, {1, 2, 4, 8}));
  EXPECT_NEAR(ratio_named(laws, "murray_exponent", "regression").value, 1, 1e-12);
  const HortonLaws cube = laws_of(measured({64, 8, 1}, {1, 2, 4}));
  EXPECT_NEAR(ratio_named(cube, "murray_exponent", "regression").value, 3, 1e-12);
}

TEST(HortonLaws, ACutTopIsSaid) {
  const HortonLaws laws = laws_of(measured({279, 92, 31, 10, 4}), 100);
  const std::string& note = ratio_named(laws, "R_B", "regression").note;
  EXPECT_TRUE(note.starts_with("4 streams of the highest order")) << note;
  EXPECT_TRUE(ratio_named(laws, "R_B", "regression_below_top").note.empty());
}

}  // namespace
}  // namespace ramify
