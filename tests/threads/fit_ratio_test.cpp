// The fit against known answers: the apple, n = 579, R = 4.35 (docs/fitting.md).
#include <cmath>
#include <map>
#include <string>

#include "support/error_of.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/fit/fit_table.hpp"
#include "ramify/fit/ratio_fitter.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/sample/sampling_method.hpp"

namespace ramify {
namespace {

// 4.9 standard errors: 1 in 10^6.
constexpr double clear = 4.9;

FitOptions options(std::uint64_t nodes_per_point, unsigned threads = 2) {
  FitOptions options;
  options.seed = test::seed_of("fit ratio");
  options.nodes_per_point = nodes_per_point;
  options.threads = threads;
  return options;
}

RatioDatum datum_of(const std::string& row) {
  return parse_ratio_data("name,ratio,branches\n" + row + "\n", "x.csv")[0];
}

const FitRow& row_of(const std::vector<FitRow>& rows, std::string_view parameter, std::size_t solution) {
  for (const FitRow& row : rows) {
    if (row.parameter == parameter && row.solution == solution) return row;
  }
  throw std::runtime_error("no row " + std::string(parameter));
}

/// Fresh trees at p, from a stream no fit used.
ResponsePoint fresh(double p, std::uint64_t trees) {
  const Cancellation cancellation;
  const ResponseSurface surface(Patricia::info(), 579, test::seed_of("fit ratio, fresh trees"), 2,
                                cancellation);
  const ResponseRequest request{p, trees};
  return surface.sample(std::span(&request, 1)).front();
}

void expect_the_rule_falls_short(const std::vector<FitRow>& apple) {
  const FitRow& rule = row_of(apple, "p_rule", 0);
  EXPECT_DOUBLE_EQ(rule.estimate, 1 / 4.35);
  // 20,000 trees of another program: 3.606.
  EXPECT_NEAR(rule.expected_at_rule, 3.606,
              clear * std::hypot(rule.expected_at_rule_error, 0.12 / std::sqrt(20000.)));
  EXPECT_LT(rule.rule_high, 4.35);
  EXPECT_NE(rule.note.find("outside"), std::string::npos);
}

void expect_one_solution_for_the_streams_mean_ratio(const std::vector<FitRow>& apple) {
  const FitRow& fit = row_of(apple, "p", 1);
  EXPECT_EQ(fit.solutions, 1u);
  EXPECT_EQ(fit.status, FitStatus::converged);
  EXPECT_EQ(fit.estimator, "streams_mean_ratio");
  EXPECT_EQ(fit.n_source, "printed");
  EXPECT_NEAR(fit.estimate, 0.1675, 0.002);
  EXPECT_LT(fit.standard_error, 0.001);
  EXPECT_LT(fit.lower, fit.estimate);
  EXPECT_GT(fit.upper, fit.estimate);
  // The rule's p is not in the interval.
  EXPECT_LT(fit.upper, 1 / 4.35);
}

void expect_the_measured_ratio_of_fresh_trees(const std::vector<FitRow>& apple) {
  const FitRow& fit = row_of(apple, "p", 1);
  const auto estimator = RatioEstimator::streams_mean_ratio;
  const ResponsePoint at_fit = fresh(fit.estimate, 4000);
  // dR/dp is about -40 there.
  const double error = std::hypot(at_fit[estimator].standard_error, 40 * fit.standard_error);
  EXPECT_NEAR(at_fit[estimator].mean, 4.35, clear * error);
  // Negative controls: nodes taken for streams, and the rule's p.
  EXPECT_GT(std::abs(at_fit[RatioEstimator::nodes_mean_ratio].mean - 4.35), 10 * error);
  const ResponsePoint at_rule = fresh(1 / 4.35, 4000);
  EXPECT_GT(std::abs(at_rule[estimator].mean - 4.35), 10 * error);
}

void expect_other_p_of_other_estimators(const std::vector<FitRow>& apple) {
  EXPECT_NEAR(row_of(apple, "p_streams_regression", 1).estimate, 0.158, 0.003);
  EXPECT_EQ(row_of(apple, "p_streams_regression", 1).solutions, 1u);
  // The nodes mean ratio rises to 4.86 near p = 0.073 and falls again: 4.35 on both sides.
  EXPECT_EQ(row_of(apple, "p_nodes_mean_ratio", 2).solutions, 2u);
  EXPECT_NEAR(row_of(apple, "p_nodes_mean_ratio", 1).estimate, 0.059, 0.003);
  EXPECT_NEAR(row_of(apple, "p_nodes_mean_ratio", 2).estimate, 0.080, 0.003);
  EXPECT_EQ(row_of(apple, "p_nodes_regression", 0).status, FitStatus::no_solution);
  EXPECT_FALSE(any_not_converged(apple));
}

void expect_the_contract_of_the_table(const std::vector<FitRow>& apple) {
  const std::string text = write_csv(fit_table(apple));
  EXPECT_TRUE(text.starts_with(
      "data,model,parameter,estimate,standard_error,lower,upper,n,n_source,estimator,observed,"));
  EXPECT_NE(text.find("\napple,patricia,p_rule,0.229885,,,,579,printed,streams_mean_ratio,4.35,"),
            std::string::npos);
  EXPECT_NE(fit_text(apple).find("apple: R 4.35, n 579 (printed)"), std::string::npos);
}

// One test: each test is a process of its own, and the fit takes seconds.
TEST(FitRatio, OfTheApple) {
  const Cancellation cancellation;
  const auto apple = fit_ratio(datum_of("apple,4.35,579"), options(400'000), cancellation);
  expect_the_rule_falls_short(apple);
  expect_one_solution_for_the_streams_mean_ratio(apple);
  expect_the_measured_ratio_of_fresh_trees(apple);
  expect_other_p_of_other_estimators(apple);
  expect_the_contract_of_the_table(apple);
}

TEST(FitRatio, NodesMeanRatioIsNotMonotone) {
  const std::map<double, double> published{{0.25, 2.89}, {0.175, 3.62}, {0.13, 3.20}};
  for (const auto& [p, mean] : published) {
    const ResponsePoint point = fresh(p, 2000);
    EXPECT_NEAR(point[RatioEstimator::nodes_mean_ratio].mean, mean,
                0.005 + clear * point[RatioEstimator::nodes_mean_ratio].standard_error);
    EXPECT_GT(std::abs(point[RatioEstimator::streams_mean_ratio].mean - mean), 0.3);
  }
}

TEST(FitRatio, SameBytesForAnyNumberOfThreadsAndAnyCompany) {
  const Cancellation cancellation;
  const RatioDatum datum = datum_of("a,3.19,100");
  const std::string one = write_csv(fit_table(fit_ratio(datum, options(20'000, 1), cancellation)));
  EXPECT_EQ(write_csv(fit_table(fit_ratio(datum, options(20'000, 2), cancellation))), one);
  EXPECT_EQ(write_csv(fit_table(fit_ratio(datum, options(20'000, 7), cancellation))), one);
  RatioFitter fitter(options(20'000), cancellation);
  fitter.fit(datum_of("b,2.9,100"));
  EXPECT_EQ(write_csv(fit_table(fitter.fit(datum))), one);
}

TEST(FitRatio, MirrorModelAndUsersSize) {
  const Cancellation cancellation;
  FitOptions dst = options(20'000);
  dst.model = &require_fittable("dst");
  dst.n = 300;
  const auto rows = fit_ratio(datum_of("a,3.5,100"), dst, cancellation);
  EXPECT_EQ(rows[0].n, 300u);
  EXPECT_EQ(rows[0].n_source, "user");
  EXPECT_EQ(rows[1].model, "dst");
  EXPECT_EQ(rows[1].status, FitStatus::converged);
}

TEST(FitRatio, IsOfModelsOfOneProbabilityAboutWhichSizesScatter) {
  for (const char* name : {"patricia", "dst"}) EXPECT_EQ(require_fittable(name).name, name);
  for (const char* name : {"bst", "beta", "split", "trie", "ternary", "aldous", "file", "no_such", ""})
    EXPECT_THROW(require_fittable(name), Error) << name;
}

TEST(FitRatio, OutOfReachAndUndetermined) {
  const Cancellation cancellation;
  // Trees of two internal nodes are chains: streams 3, 1 for every p.
  const auto chain = fit_ratio(datum_of("a,3,2"), options(1000), cancellation);
  EXPECT_EQ(row_of(chain, "p", 0).status, FitStatus::undetermined);
  EXPECT_EQ(row_of(chain, "p_streams_regression", 0).status, FitStatus::undetermined);
  const auto far = fit_ratio(datum_of("a,3.2,2"), options(1000), cancellation);
  EXPECT_EQ(row_of(far, "p", 0).status, FitStatus::no_solution);
  EXPECT_TRUE(std::isnan(row_of(far, "p", 0).estimate));
  EXPECT_FALSE(any_not_converged(far));
}

TEST(FitRatio, WithoutASizeThereIsTheRuleAlone) {
  const Cancellation cancellation;
  const auto rows =
      fit_ratio(parse_ratio_data("name,ratio\noak,4.11\n", "x.csv")[0], options(1000), cancellation);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].parameter, "p_rule");
  EXPECT_EQ(rows[0].n, 0u);
  EXPECT_NE(rows[0].note.find("--n"), std::string::npos);
}

TEST(FitRatio, MurrayExponent) {
  const Cancellation cancellation;
  const auto rows = fit_ratio(parse_ratio_data("name,ratio,diameter_ratio\nlung,2.74,1.40\n", "x.csv")[0],
                              options(1000), cancellation);
  const FitRow& murray = row_of(rows, "murray_exponent", 0);
  EXPECT_NEAR(murray.estimate, 2.99566, 1e-5);
  EXPECT_NEAR(murray.lower, std::log(2.735) / std::log(1.405), 1e-12);
  EXPECT_NEAR(murray.upper, std::log(2.745) / std::log(1.395), 1e-12);
}

// From largest_counted on the counts of small subtrees are averaged: no step in what is fitted.
TEST(FitRatio, MeetsItselfWhereAveragingBegins) {
  const Cancellation cancellation;
  const ResponseRequest request{0.3, 200};
  const auto at = [&](Size n) {
    return ResponseSurface(Patricia::info(), n, test::seed_of("averaging"), 2, cancellation)
        .sample(std::span(&request, 1))[0];
  };
  const ResponsePoint counted = at(largest_counted), averaged = at(largest_counted + 1);
  for (std::size_t e = 0; e < ratio_estimator_count; ++e) {
    const ResponseSummary &a = counted.summary[e], &b = averaged.summary[e];
    // Of trees of one order the geometric ratio is a function of n alone.
    EXPECT_NEAR(a.mean, b.mean, clear * std::hypot(a.standard_error, b.standard_error) + 1e-6);
  }
}

TEST(FitRatio, RefusesSizesThatCannotBeGrown) {
  const Cancellation cancellation;
  const std::string said =
      test::error_of([&] { fit_ratio(datum_of("a,3,2000000000"), options(1000), cancellation); });
  EXPECT_TRUE(said.starts_with("x.csv:2: ")) << said;
}

TEST(FitRatio, StopsWhenAsked) {
  Cancellation cancellation;
  cancellation.request();
  EXPECT_THROW(fit_ratio(datum_of("a,3,100"), options(1000), cancellation), Interrupted);
}

}  // namespace
}  // namespace ramify
