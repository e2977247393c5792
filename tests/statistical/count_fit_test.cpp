// Families fitted to stream counts: the likelihood by its definition, its slopes, and whether intervals
// cover.
#include "ramify/fit/count_fit.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <Eigen/Dense>
#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "ramify/fit/limiting_ratio.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/sample/grow_blocks.hpp"

namespace ramify::test {
namespace {

const ObservedCounts walnut{{1868, 596, 182, 50, 16, 6, 1}};

/// Stream counts of trees of a family.
std::vector<ObservedCounts> grown_counts(const Family& family, const std::vector<double>& values, Size n,
                                         std::uint64_t trees) {
  std::vector<ObservedCounts> counts(trees);
  const GrowingJob job{family.at(values), n, seed_of("count_fit"), {orders_and_height, true}, 0, trees};
  grow_blocks({job}, 2, uninterrupted, [&](const Block&, const BlockTrees& grown) {
    grown.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      counts[replicate].streams.assign(measures.streams.begin(),
                                       measures.streams.begin() + measures.strahler + 1);
    });
  });
  return counts;
}

/// The definition: the Gaussian density by the inverse and the determinant of the covariances.
double literal_minus_log_likelihood(const Model& model, const ObservedCounts& counts) {
  const StreamCounts law = stream_counts(model, counts.n());
  const auto orders = static_cast<Eigen::Index>(counts.reading().orders);
  Eigen::VectorXd off(orders);
  Eigen::MatrixXd covariances(orders, orders);
  for (Eigen::Index j = 0; j < orders; ++j) {
    const auto order = static_cast<std::size_t>(j) + 1;
    off[j] = static_cast<double>(counts.streams[order]) - law.means[order];
    for (Eigen::Index k = 0; k < orders; ++k)
      covariances(j, k) = law.covariance(order, static_cast<std::size_t>(k) + 1) + (j == k ? 1.0 / 12 : 0);
  }
  const double of_order = law.order_tail[counts.top()] - law.order_tail[counts.top() + 1];
  return (static_cast<double>(orders) * std::log(2 * std::numbers::pi) + std::log(covariances.determinant()) +
          off.dot(covariances.inverse() * off)) /
             2 -
         std::log(of_order + 1e-5);
}

TEST(CountLikelihood, IsTheGaussianDensityTimesTheLawOfTheOrder) {
  if (sanitized) GTEST_SKIP() << "HasTheSlopesOfItsDifferences runs the same code";
  CountFitter fitter(2, uninterrupted);
  for (const char* name : {"patricia", "aldous", "ford", "bst", "catalan"}) {
    const Family& family = find_family(name);
    FamilyFit fit = fitter.fit(family, walnut);
    fitter.settle(fit, walnut);
    const CountSurface& surface = fitter.surface(family, walnut.n());
    const double read = count_objective(surface, walnut).value(family.searched(fit.estimates()));
    EXPECT_NEAR(-fit.log_likelihood, read, 0.01) << name;
    EXPECT_NEAR(-fit.log_likelihood, literal_minus_log_likelihood(family.at(fit.estimates()), walnut), 1e-8)
        << name;
  }
}

/// Within Huber's scale it is the Gaussian likelihood but for what the density integrates to.
TEST(CountLikelihood, OfHubersLossIsThatOfItsDensity) {
  const auto rho = [](double z) {
    const double far = std::abs(z);
    return far <= huber_scale ? z * z : 2 * huber_scale * far - huber_scale * huber_scale;
  };
  double integral = 0;
  for (double z = -60; z < 60; z += 1e-3) integral += 1e-3 * std::exp(-rho(z) / 2);
  const Family& family = find_family("patricia");
  const CountSurface surface(family, walnut.n(), 2, uninterrupted);
  for (const double p : {0.2, 0.23, 0.3}) {
    const Point at = family.searched(std::vector{p});
    const CountFitness plain = count_fitness(surface, walnut, at);
    double expected = -plain.log_likelihood;
    for (const double z : plain.residuals)
      expected += (rho(z) - z * z) / 2 + std::log(integral) - std::log(2 * std::numbers::pi) / 2;
    EXPECT_NEAR(-count_fitness(surface, walnut, at, CountDensity::huber).log_likelihood, expected, 1e-5) << p;
  }
}

/// Mean counts of a family, to whole streams.
ObservedCounts mean_counts(const Model& model, Size n, std::size_t orders) {
  const StreamCounts law = stream_counts(model, n);
  ObservedCounts counts{{n + 1}};
  for (std::size_t k = 1; k < orders; ++k)
    counts.streams.push_back(static_cast<std::uint64_t>(std::llround(law.means[k])));
  counts.streams.push_back(1);
  return counts;
}

/// One odd order moves a fit by Huber's loss far less than the Gaussian one, and without one they agree.
TEST(CountFit, OneOddOrderDoesNotDecideAloneWhereTheLossIsRobust) {
  if (sanitized) GTEST_SKIP() << "OfHubersLossIsThatOfItsDensity runs the same code";
  const Family& family = find_family("patricia");
  const ObservedCounts clean = mean_counts(family.at(std::vector{0.23}), 2000, 6);
  ObservedCounts odd = clean;
  odd.streams[3] = odd.streams[3] * 3 / 2;
  CountFitter gaussian(2, uninterrupted), robust(2, uninterrupted, CountDensity::huber);
  const FittedParameter known = gaussian.fit(family, clean).parameters[0];
  const auto off = [&](CountFitter& fitter, const ObservedCounts& counts) {
    const FamilyFit fit = fitter.fit(family, counts);
    EXPECT_TRUE(fit.converged);
    return std::abs(fit.parameters[0].estimate - known.estimate) / known.standard_error;
  };
  EXPECT_NEAR(known.estimate, 0.23, 2 * known.standard_error);
  EXPECT_LT(off(robust, clean), 0.01);
  EXPECT_GT(off(gaussian, odd), 2);
  EXPECT_LT(off(robust, odd), off(gaussian, odd) / 2);
  FamilyFit fit = robust.fit(family, odd);
  robust.settle(fit, odd);
  EXPECT_NE(fit.note.find("Huber's loss beyond 1.345 standard deviations: order 3 (+"), std::string::npos)
      << fit.note;
}

/// Along the interval, and across the seams of panels: the estimate of ford is beside one.
TEST(CountLikelihood, IsReadBetweenLawsWhereTheIntervalIs) {
  if (sanitized) GTEST_SKIP() << "HasTheSlopesOfItsDifferences runs the same code";
  const ObservedCounts apple{{279, 52, 7, 1}};
  CountFitter fitter(2, uninterrupted);
  for (const char* name : {"ford", "patricia"}) {
    const Family& family = find_family(name);
    const FamilyFit fit = fitter.fit(family, apple);
    const CountSurface& surface = fitter.surface(family, apple.n());
    const Objective objective = count_objective(surface, apple);
    const FittedParameter& found = fit.parameters[0];
    for (int i = 0; i <= 10; ++i) {
      const Point at = family.searched(std::vector{found.lower + i * (found.upper - found.lower) / 10});
      EXPECT_NEAR(objective.value(at), -count_fitness(surface, apple, at).log_likelihood, 0.01)
          << name << ' ' << i;
    }
  }
}

TEST(CountLikelihood, HasTheSlopesOfItsDifferences) {
  for (const char* name : {"patricia", "aldous", "ford", "beta_multinomial", "ternary"}) {
    const Family& family = find_family(name);
    const ObservedCounts apple{{280, 52, 7, 1}};
    const CountSurface surface(family, apple.n(), 2, uninterrupted);
    for (const CountDensity density : {CountDensity::gaussian, CountDensity::huber}) {
      const Objective objective = count_objective(surface, apple, density);
      for (const Point& at : family.starts()) {
        Point gradient(at.size());
        double value = 0;
        ASSERT_TRUE(objective.evaluate(at, value, gradient.data())) << name;
        for (std::size_t i = 0; i < at.size(); ++i) {
          Point up = at, down = at;
          up[i] += 1e-5;
          down[i] -= 1e-5;
          const double slope = (objective.value(up) - objective.value(down)) / 2e-5;
          EXPECT_NEAR(gradient[i], slope, 1e-6 * std::max(1.0, std::abs(value))) << name << ' ' << i;
        }
      }
    }
  }
}

TEST(CountLikelihood, IsTheSameOfMirrorImages) {
  const ObservedCounts apple{{280, 52, 7, 1}};
  const CountSurface strings(find_family("patricia"), apple.n(), 2, uninterrupted);
  const Objective of_p = count_objective(strings, apple);
  EXPECT_EQ(of_p.value(std::vector{-1.3}), of_p.value(std::vector{1.3}));
  const CountSurface shapes(find_family("beta_multinomial"), apple.n(), 2, uninterrupted);
  const Objective of_shapes = count_objective(shapes, apple);
  EXPECT_EQ(of_shapes.value(std::vector{0.3, 1.7}), of_shapes.value(std::vector{1.7, 0.3}));
}

/// What measured trees say (docs/fitting-models.md): the creek is a random topology in Shreve's sense, the
/// walnut is not.
TEST(CountFit, TheCreekIsUniformAndTheWalnutIsNot) {
  CountFitter fitter(2, uninterrupted);
  const ObservedCounts creek{{144, 36, 11, 3, 1}};
  EXPECT_GT(fitter.fit(find_family("catalan"), creek).goodness.p_value, 0.05);
  EXPECT_LT(fitter.fit(find_family("bst"), creek).goodness.p_value, 1e-3);
  EXPECT_LT(fitter.fit(find_family("catalan"), walnut).goodness.p_value, 1e-10);
  const FamilyFit aldous = fitter.fit(find_family("aldous"), creek);
  EXPECT_LT(aldous.parameters[0].lower, -1.5);
  EXPECT_GT(aldous.parameters[0].upper, -1.5);
}

/// Of so many intervals at 95 %, how many cover; `shrunk` to half of their width they must not.
void expect_coverage(const char* name, double truth, Size n) {
  constexpr std::uint64_t trees = 300;
  const Family& family = find_family(name);
  CountFitter fitter(2, uninterrupted);
  std::uint64_t covered = 0, shrunk = 0;
  for (const ObservedCounts& counts : grown_counts(family, {truth}, n, trees)) {
    const FamilyFit fit = fitter.fit(family, counts);
    ASSERT_TRUE(fit.converged) << name;
    const FittedParameter& found = fit.parameters[0];
    covered += found.lower <= truth && truth <= found.upper ? 1 : 0;
    const double low = (found.lower + found.estimate) / 2, high = (found.upper + found.estimate) / 2;
    shrunk += low <= truth && truth <= high ? 1 : 0;
  }
  const boost::math::binomial_distribution<> law(static_cast<double>(trees), 0.95);
  const auto p_value = [&law](std::uint64_t count) {
    const auto x = static_cast<double>(count);
    return std::min(1.0, 2 * std::min(cdf(law, x), x < 1 ? 1.0 : cdf(complement(law, x - 1))));
  };
  EXPECT_TRUE(agrees({std::string(name) + ", cover", static_cast<double>(covered), 0, p_value(covered)}));
  EXPECT_TRUE(
      rejected({std::string(name) + ", half as wide", static_cast<double>(shrunk), 0, p_value(shrunk)}));
}

TEST(CountFit, IntervalsCoverTheTruthNineteenTimesOfTwenty) {
  if (sanitized) GTEST_SKIP() << "ABootstrapDependsOnTheSeedAlone runs the same code";
  expect_coverage("patricia", 0.23, 579);
  expect_coverage("dst", 0.1, 579);
  expect_coverage("aldous", -1, 2000);
  expect_coverage("ford", 0.3, 2000);
}

TEST(CountFit, ABootstrapDependsOnTheSeedAloneAndSaysWhatTheCurvatureSays) {
  const ObservedCounts creek{{144, 36, 11, 3, 1}};
  const Family& family = find_family("aldous");
  FamilyFit one = CountFitter(1, uninterrupted).fit(family, creek), three = one;
  CountFitter on_one(1, uninterrupted), on_three(3, uninterrupted);
  on_one.bootstrap(one, creek, {400, 7});
  on_three.bootstrap(three, creek, {400, 7});
  ASSERT_EQ(one.bootstrap.size(), 1u);
  EXPECT_EQ(one.bootstrap[0].lower, three.bootstrap[0].lower);
  EXPECT_EQ(one.bootstrap[0].deviation, three.bootstrap[0].deviation);
  EXPECT_EQ(one.goodness.p_value, three.goodness.p_value);
  EXPECT_NEAR(one.bootstrap[0].deviation / one.parameters[0].standard_error, 1, 0.35);
  EXPECT_GT(one.goodness.p_value, 0.01);
}

/// Of two shapes counts fix the limiting ratio, and it is that of the tree they came from.
TEST(CountFit, TheRatioOfTwoShapesIsKnownBetterThanTheShapes) {
  if (sanitized) GTEST_SKIP() << "a fit of two parameters takes twenty seconds";
  const Family& family = find_family("beta_multinomial");
  const auto counts = grown_counts(family, {2, 5}, 250, 1);
  const FamilyFit fit = CountFitter(2, uninterrupted).fit(family, counts[0]);
  const auto ratio = limiting_ratio(fit);
  ASSERT_TRUE(ratio.has_value());
  EXPECT_LT(ratio->standard_error / ratio->estimate,
            fit.parameters[1].standard_error / fit.parameters[1].estimate);
  EXPECT_GT(ratio->lower, 2);
  EXPECT_LT(ratio->upper, 5);
}

/// Along the valley the likelihood is that of a law at every stop, R(a,b) changes less than the shapes do,
/// and the ends of the intervals lie within it.
TEST(CountFit, TheValleyListsThePairsThatFitNearlyAsWell) {
  if (sanitized) GTEST_SKIP() << "a fit of two parameters takes twenty seconds";
  const Family& family = find_family("beta_multinomial");
  const ObservedCounts apple{{279, 52, 7, 1}};
  CountFitter fitter(2, uninterrupted);
  FamilyFit fit = fitter.fit(family, apple);
  fitter.trace_valley(fit, apple);
  ASSERT_EQ(fit.valley.size(), 26u);
  const auto best = std::ranges::max_element(fit.valley, {}, &ValleyPoint::log_likelihood);
  EXPECT_NEAR(std::log(best->a / fit.parameters[0].estimate), 0, 0.02);
  for (const ValleyPoint& point : fit.valley) {
    const ValleyPoint known = point;
    EXPECT_NEAR(point.log_likelihood,
                -literal_minus_log_likelihood(family.at(std::vector{known.a, known.b}), apple), 1e-8);
    EXPECT_LT(best->log_likelihood - point.log_likelihood, 3.02);
  }
  const ValleyPoint &low = fit.valley.front(), &high = fit.valley.back();
  EXPECT_NEAR(best->log_likelihood - low.log_likelihood, 3, 0.02);
  EXPECT_LT(std::log(high.horton_ratio / low.horton_ratio), std::log(high.b / low.b));
  EXPECT_LT(low.a, fit.parameters[0].lower);
  EXPECT_GT(high.b, fit.parameters[1].upper);
}

}  // namespace
}  // namespace ramify::test
