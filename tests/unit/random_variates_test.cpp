#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/seed.hpp"
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/random/stream.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {
namespace {

using test::agrees;
using test::chi_square;
using test::rejected;
using test::SampleMean;
using test::seed_of;
using test::z_test;

constexpr std::size_t bins = 32;
const std::vector<double> flat(bins, 1.0);

std::size_t bin_of(double level) {
  return std::min(bins - 1, static_cast<std::size_t>(level * static_cast<double>(bins)));
}

/// P(X <= x) from the end that x is nearer to.
double beta_level(const UnitPair& pair, double a, double b) {
  return pair.x <= pair.complement ? boost::math::ibeta(a, b, pair.x)
                                   : boost::math::ibetac(b, a, pair.complement);
}

struct Shapes {
  double a, b;

  friend std::ostream& operator<<(std::ostream& out, const Shapes& shapes) {
    return out << shapes.a << ',' << shapes.b;
  }
};

class BetaVariate : public ::testing::TestWithParam<Shapes> {};

TEST_P(BetaVariate, IsAPairThatSumsToOne) {
  const auto [a, b] = GetParam();
  Stream stream({seed_of("beta pair"), static_cast<std::uint64_t>(100 * a + b)}, 0);
  for (int i = 0; i < 20000; ++i) {
    const UnitPair pair = beta_variate(stream, a, b);
    ASSERT_TRUE(pair.x >= 0 && pair.x <= 1 && pair.complement >= 0 && pair.complement <= 1);
    ASSERT_NEAR(pair.x + pair.complement, 1, 0x1p-52);
    ASSERT_FALSE(pair.x == 1 && pair.complement == 1);
  }
}

TEST_P(BetaVariate, AgreesWithTheIncompleteBeta) {
  const auto [a, b] = GetParam();
  Stream stream({seed_of("beta law"), static_cast<std::uint64_t>(100 * a + b)}, 0);
  std::vector<std::uint64_t> counts(bins, 0), shifted(bins, 0);
  for (int i = 0; i < 20000; ++i) {
    const UnitPair pair = beta_variate(stream, a, b);
    ++counts[bin_of(beta_level(pair, a, b))];
    ++shifted[bin_of(a <= b ? beta_level(pair, 1.3 * a, b) : beta_level(pair, a, 1.3 * b))];
  }
  EXPECT_TRUE(agrees(chi_square("beta", counts, flat)));
  EXPECT_TRUE(rejected(chi_square("beta, the smaller parameter wrong by 30 %", shifted, flat)));
}

std::vector<Shapes> shape_grid() {
  std::vector<Shapes> grid;
  for (const double a : {0.01, 0.1, 1.0, 10.0, 1000.0})
    for (const double b : {0.01, 0.1, 1.0, 10.0, 1000.0}) grid.push_back({a, b});
  return grid;
}

INSTANTIATE_TEST_SUITE_P(Shapes, BetaVariate, ::testing::ValuesIn(shape_grid()), [](const auto& instance) {
  const auto percent = [](double x) { return std::lround(100 * x); };
  return fmt::format("{}_{}_percent", percent(instance.param.a), percent(instance.param.b));
});

/// P(G <= exp(log_g)); below exp(-50) the first term of the series is the whole.
double gamma_level(double log_g, double shape) {
  if (log_g < -50) return std::exp(shape * log_g - std::lgamma(shape + 1));
  return boost::math::gamma_p(shape, std::exp(log_g));
}

TEST(LogGammaVariate, AgreesWithTheIncompleteGamma) {
  for (const double shape : {0.01, 0.1, 0.5, 1.0, 1.5, 10.0, 1000.0}) {
    Stream stream({seed_of("log gamma"), static_cast<std::uint64_t>(100 * shape)}, 0);
    std::vector<std::uint64_t> counts(bins, 0);
    SampleMean mean;
    for (int i = 0; i < 50000; ++i) {
      const double log_g = log_gamma_variate(stream, shape);
      ASSERT_TRUE(std::isfinite(log_g));
      ++counts[bin_of(gamma_level(log_g, shape))];
      mean.add(log_g);
    }
    EXPECT_TRUE(agrees(chi_square("log gamma", counts, flat)));
    EXPECT_TRUE(agrees(z_test("E log G", mean, boost::math::digamma(shape))));
  }
}

/// The weights C(m,k) p^k q^(m-k) from log-gammas.
std::vector<double> binomial_law(std::uint64_t m, double p) {
  std::vector<double> law;
  const double trials = static_cast<double>(m);
  for (double k = 0; k <= trials; ++k)
    law.push_back(std::exp(std::lgamma(trials + 1) - std::lgamma(k + 1) - std::lgamma(trials - k + 1) +
                           k * std::log(p) + (trials - k) * std::log1p(-p)));
  return law;
}

struct Binomial {
  std::uint64_t trials;
  double p;
};

TEST(BinomialVariate, AgreesWithItsLaw) {
  const std::vector<Binomial> cases{{1, 0.3},   {10, 0.5},    {100, 0.01}, {100, 0.99},
                                    {100, 0.3}, {1000, 0.23}, {5000, 0.77}};
  for (const auto& [trials, p] : cases) {
    Stream stream({seed_of("binomial"), trials}, static_cast<std::uint64_t>(1000 * p));
    std::vector<std::uint64_t> counts(trials + 1, 0);
    for (int i = 0; i < 200000; ++i) ++counts.at(binomial_variate(stream, trials, p));
    EXPECT_TRUE(agrees(chi_square("binomial", counts, binomial_law(trials, p))));
    EXPECT_TRUE(
        rejected(chi_square("binomial, p 10 % low", counts, binomial_law(trials, 0.9 * p), 200000.0 / 64)));
  }
}

TEST(BinomialVariate, HasItsMeanAtTwoToTheFifty) {
  const std::uint64_t trials = std::uint64_t{1} << 50;
  for (const double p : {0.5, 0.23}) {
    Stream stream({seed_of("binomial, huge"), 0}, static_cast<std::uint64_t>(100 * p));
    const double centre = static_cast<double>(trials) * p;
    const double spread = std::sqrt(centre * (1 - p));
    SampleMean mean, square;
    for (int i = 0; i < 50000; ++i) {
      const double z = (static_cast<double>(binomial_variate(stream, trials, p)) - centre) / spread;
      mean.add(z);
      square.add(z * z);
    }
    EXPECT_TRUE(agrees(z_test("binomial, huge, mean", mean, 0)));
    EXPECT_TRUE(agrees(z_test("binomial, huge, variance", square, 1)));
  }
}

TEST(BinomialVariate, OfAPairAgreesWithItsLaw) {
  const std::vector<Binomial> cases{{1, 0.3},   {10, 0.5},     {100, 0.01},  {100, 0.99},
                                    {100, 0.3}, {1000, 0.011}, {1000, 0.989}};
  for (const auto& [trials, p] : cases) {
    Stream stream({seed_of("binomial of a pair"), trials}, static_cast<std::uint64_t>(1000 * p));
    std::vector<std::uint64_t> counts(trials + 1, 0);
    for (int i = 0; i < 200000; ++i) ++counts.at(binomial_variate(stream, trials, UnitPair{p, 1 - p}));
    EXPECT_TRUE(agrees(chi_square("binomial of a pair", counts, binomial_law(trials, p))));
    EXPECT_TRUE(rejected(
        chi_square("binomial of a pair, p 10 % low", counts, binomial_law(trials, 0.9 * p), 200000.0 / 64)));
  }
}

TEST(BinomialVariate, OfAPairHoldsAtItsEnds) {
  Stream stream({seed_of("binomial of a pair, ends"), 0}, 0);
  constexpr std::uint64_t trials = std::uint64_t{1} << 50;
  for (const std::uint64_t m : {std::uint64_t{0}, std::uint64_t{1}, trials}) {
    EXPECT_EQ(binomial_variate(stream, m, UnitPair{0, 1}), 0u);
    EXPECT_EQ(binomial_variate(stream, m, UnitPair{1, 0}), m);
    EXPECT_EQ(binomial_variate(stream, m, UnitPair{1e-300, 1}), 0u);
  }
  // A mean of 0.2: log(1-p) from 1-p would be 30 % off.
  const double p = 1.6e-16, expected = static_cast<double>(trials) * p;
  SampleMean low, high;
  for (int i = 0; i < 100000; ++i) {
    low.add(static_cast<double>(binomial_variate(stream, trials, UnitPair{p, 1 - p})));
    high.add(static_cast<double>(trials - binomial_variate(stream, trials, UnitPair{1 - p, p})));
  }
  EXPECT_TRUE(agrees(z_test("rare successes", low, expected)));
  EXPECT_TRUE(agrees(z_test("rare failures", high, expected)));
  EXPECT_TRUE(
      rejected(z_test("rare successes, 1-p in double", low, -static_cast<double>(trials) * std::log(1 - p))));
}

std::vector<double> inner_law(std::uint64_t m, double p) {
  auto law = binomial_law(m, p);
  law.front() = law.back() = 0;
  return law;
}

std::vector<double> positive_law(std::uint64_t m, double p) {
  auto law = binomial_law(m, p);
  law.front() = 0;
  return law;
}

TEST(PositiveBinomialVariate, AgreesWithItsLaw) {
  const std::vector<Binomial> cases{{1, 0.3},  {2, 0.6},    {2, 0.9},    {16, 0.5}, {17, 0.5},
                                    {9, 0.02}, {100, 0.01}, {100, 0.99}, {60, 0.2}, {1000, 0.0001}};
  for (const auto& [trials, p] : cases) {
    Stream stream({seed_of("positive binomial"), trials}, static_cast<std::uint64_t>(10000 * p));
    std::vector<std::uint64_t> counts(trials + 1, 0), any(trials + 1, 0);
    for (int i = 0; i < 200000; ++i) {
      ++counts.at(positive_binomial_variate(stream, trials, UnitPair{p, 1 - p}));
      ++any.at(binomial_variate(stream, trials, UnitPair{p, 1 - p}));
    }
    EXPECT_TRUE(agrees(chi_square("positive binomial", counts, positive_law(trials, p))));
    if (std::pow(1 - p, static_cast<double>(trials)) > 1e-3) {
      EXPECT_TRUE(rejected(chi_square("positive binomial, 0 too", any, positive_law(trials, p))));
    }
  }
}

TEST(PositiveBinomialVariate, HasItsLimitsAtTheEnds) {
  Stream stream({seed_of("positive binomial, ends"), 0}, 0);
  for (const std::uint64_t m : {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{1} << 50}) {
    EXPECT_EQ(positive_binomial_variate(stream, m, UnitPair{0, 1}), 1u);
    EXPECT_EQ(positive_binomial_variate(stream, m, UnitPair{1e-300, 1}), 1u);
    EXPECT_EQ(positive_binomial_variate(stream, m, UnitPair{1, 0}), m);
  }
}

TEST(InnerBinomialVariate, AgreesWithItsLaw) {
  const std::vector<Binomial> cases{{2, 0.3},    {3, 0.5},     {3, 0.1},    {16, 0.5},     {17, 0.5},
                                    {17, 0.501}, {20, 0.01},   {20, 0.99},  {100, 0.0799}, {100, 0.0801},
                                    {100, 0.95}, {1000, 1e-4}, {1000, 0.3}, {1000, 0.999}};
  for (const auto& [trials, p] : cases) {
    Stream stream({seed_of("inner binomial"), trials}, static_cast<std::uint64_t>(10000 * p));
    std::vector<std::uint64_t> counts(trials + 1, 0);
    for (int i = 0; i < 100000; ++i) ++counts.at(inner_binomial_variate(stream, trials, p));
    EXPECT_TRUE(agrees(chi_square("inner binomial", counts, inner_law(trials, p))));
    EXPECT_EQ(counts.front() + counts.back(), 0u);
    if (trials == 2) continue;  // 1 is the only outcome
    EXPECT_TRUE(rejected(
        chi_square("inner binomial, p 30 % low", counts, inner_law(trials, 0.7 * p), 100000.0 / 64)));
  }
}

TEST(InnerBinomialVariate, HoldsAtTheEndsOfP) {
  Stream stream({seed_of("inner binomial, ends"), 0}, 0);
  int rare_low = 0, rare_high = 0;
  for (int i = 0; i < 20000; ++i) {
    EXPECT_EQ(inner_binomial_variate(stream, 2, 1e-9), 1u);
    EXPECT_EQ(inner_binomial_variate(stream, 2, 1 - 1e-9), 1u);
    rare_low += inner_binomial_variate(stream, 1000, 1e-9) != 1 ? 1 : 0;  // probability 5e-7
    rare_high += inner_binomial_variate(stream, 1000, 1 - 1e-9) != 999 ? 1 : 0;
  }
  EXPECT_LE(rare_low, 2);
  EXPECT_LE(rare_high, 2);
}

// 10^12 strings, p = 10^-12: K is Poisson(1) given K >= 1.
TEST(InnerBinomialVariate, IsPoissonForRareBits) {
  Stream stream({seed_of("inner binomial, Poisson"), 0}, 0);
  std::vector<std::uint64_t> counts(20, 0);
  for (int i = 0; i < 100000; ++i) ++counts.at(inner_binomial_variate(stream, 1000000000000, 1e-12));
  std::vector<double> law(20, 0.0);
  for (std::size_t k = 1; k < law.size(); ++k) law[k] = 1 / std::tgamma(static_cast<double>(k) + 1);
  EXPECT_TRUE(agrees(chi_square("inner binomial, Poisson", counts, law)));
}

}  // namespace
}  // namespace ramify
