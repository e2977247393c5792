// Tails of totals of clumps against sums over the number of clumps.
#include <cmath>

#include <boost/math/distributions/negative_binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <gtest/gtest.h>

#include "ramify/compare/clumped_count.hpp"

namespace ramify {
namespace {

/// P(X >= x), x >= 1, of a Poisson number of clumps, k of which have k + a negative binomial number.
double tail_by_clumps(double x, double clumps, double stay) {
  const boost::math::poisson number(clumps);
  double tail = 0;
  for (double k = 1; k < clumps + 40 * std::sqrt(clumps) + 60; ++k) {
    const double above = k >= x ? 1 : cdf(complement(boost::math::negative_binomial(k, 1 - stay), x - k - 1));
    tail += pdf(number, k) * above;
  }
  return tail;
}

double z_of_tail(double tail) {
  return quantile(complement(boost::math::normal(), tail));
}

TEST(ClumpedCount, HasTheTailOfAPoissonNumberOfGeometricClumps) {
  for (const double clumps : {0.01, 0.7, 12.0, 90.0})
    for (const double stay : {0.05, 0.6, 0.95}) {
      const double mean = clumps / (1 - stay), variance = mean * (1 + stay) / (1 - stay);
      for (const double sigmas : {1.5, 3.0, 6.0}) {
        const double total = std::ceil(mean + sigmas * std::sqrt(variance));
        EXPECT_NEAR(clumped_count_z(total, mean, variance), z_of_tail(tail_by_clumps(total, clumps, stay)),
                    1e-8)
            << clumps << ' ' << stay << ' ' << total;
      }
    }
  const double clumps = 30, stay = 0.6, mean = 75;
  for (const double total : {15.0, 25.0, 40.0})
    EXPECT_NEAR(clumped_count_z(total, mean, 300), -z_of_tail(1 - tail_by_clumps(total + 1, clumps, stay)),
                1e-6)
        << total;
  EXPECT_NEAR(clumped_count_z(0, mean, 300), -z_of_tail(std::exp(-clumps)), 1e-8);
}

TEST(ClumpedCount, IsPoissonWhereTheVarianceIsNoLargerThanTheMean) {
  for (const double variance : {20.0, 12.0})
    for (const double total : {21.0, 30.0, 48.0})
      EXPECT_NEAR(clumped_count_z(total, 20, variance),
                  z_of_tail(cdf(complement(boost::math::poisson(20), total - 1))), 1e-9);
}

TEST(ClumpedCount, IsNoughtWhereHalfOfAllGoAsFarAndFiniteWhereNoneDoes) {
  EXPECT_EQ(clumped_count_z(0, 0.3, 0.3), 0);
  EXPECT_EQ(clumped_count_z(0, 0, 0), 0);
  EXPECT_NEAR(clumped_count_z(1, 0, 0), 37.5, 0.1);
  EXPECT_NEAR(clumped_count_z(1, 1e-9, 1e-9), z_of_tail(1e-9), 1e-6);
  EXPECT_LT(clumped_count_z(0, 40, 40), -8);
}

// Where normal tails take over the two are close.
TEST(ClumpedCount, GoesOverIntoTheNormalLaw) {
  const double mean = 4000, variance = mean * mean / largest_clump_ratio, deviation = std::sqrt(variance);
  for (const double sigmas : {-4.0, -2.0, 2.0, 4.0}) {
    const double z = clumped_count_z(std::round(mean + sigmas * deviation), mean, variance);
    EXPECT_NEAR(z, sigmas, 0.05 + 0.02 * sigmas * sigmas);
    EXPECT_LT(z, sigmas) << "the law is skewed to the right";
  }
}

}  // namespace
}  // namespace ramify
