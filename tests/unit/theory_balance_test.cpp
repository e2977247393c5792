#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/theory/balance_constant.hpp"
#include "ramify/theory/beta_balance.hpp"
#include "ramify/theory/constants.hpp"

namespace {

using ramify::beta_balance;
using ramify::Model;

TEST(BstBalance, IsNotOneOverLogThree) {
  const auto balance = ramify::bst_balance();
  EXPECT_NEAR(balance.value, 1.02624823037913934, 3e-16);
  EXPECT_LE(balance.error, 1e-15);
  EXPECT_GT(balance.value - 1 / std::log(3.0), 0.1);  // theorem C.2 as printed
}

struct BalanceValue {
  double a, b;
  double balance;

  friend std::ostream& operator<<(std::ostream& out, const BalanceValue& known) {
    return out << "beta(" << known.a << ',' << known.b << ')';
  }
};

class KnownBalance : public testing::TestWithParam<BalanceValue> {};

TEST_P(KnownBalance, IsMet) {
  const auto& [a, b, known] = GetParam();
  const auto balance = beta_balance({a, b});
  ASSERT_TRUE(balance) << a << " " << b;
  EXPECT_NEAR(balance->value, known, 1e-10) << a << " " << b;
  EXPECT_LE(balance->error, 1e-12 * balance->value) << a << " " << b;
}

// Computed apart, by quadrature; tolerance: one unit of the last digit.
INSTANTIATE_TEST_SUITE_P(
    Theory, KnownBalance,
    testing::Values(BalanceValue{2, 2, 1.0730075546}, BalanceValue{5, 5, 1.1463589246},
                    BalanceValue{10, 10, 1.2027710171}, BalanceValue{100, 100, 1.3441122258},
                    BalanceValue{0.5, 0.5, 0.9915500406}, BalanceValue{0.1, 0.1, 0.9528363043},
                    BalanceValue{1, 3, 0.9919614315}, BalanceValue{1, 5, 0.8947074699},
                    BalanceValue{1, 10, 0.7007852289}, BalanceValue{2, 5, 1.0098859716},
                    BalanceValue{5, 20, 0.7780182689}, BalanceValue{10, 20, 1.0260760827},
                    BalanceValue{10, 80, 0.5275720393}, BalanceValue{20, 80, 0.6813025677}));

TEST(BetaBalance, OfTheUniformSplitIsThatOfTheBst) {
  const auto bst = ramify::bst_balance();
  for (const auto& [a, b] : std::vector<ramify::BetaSplit>{{1, 1}, {1, 2}, {2, 1}}) {
    const auto beta = beta_balance({a, b});
    EXPECT_NEAR(beta->value, bst.value, bst.error + beta->error) << a << " " << b;
  }
}

TEST(BetaBalance, DoesNotTellLeftFromRight) {
  for (const auto& [a, b] : std::vector<ramify::BetaSplit>{{0.01, 3}, {10, 80}}) {
    const auto left = beta_balance({a, b}), right = beta_balance({b, a});
    EXPECT_NEAR(left->value, right->value, left->error + right->error);
  }
  const auto even = beta_balance({7, 7}), uneven = beta_balance({7, 8});  // the same unordered split
  EXPECT_NEAR(even->value, uneven->value, even->error + uneven->error);
}

// The formula again, in doubles: Simpson's rule in z = log x, on which both integrals are smooth, and t on a
// fine grid.
//   e^theta = integral of w (1 - (1-x)^t) / integral of w x^t over (0,1/2), w = x^(a-1) (1-x)^(b-1) + x^(b-1)
//   (1-x)^(a-1)
double balance_on_a_grid(double a, double b) {
  constexpr int cells = 2000;
  const double lowest = -60 / std::min({a + 1, b + 1, 2.0}) - 10, width = (std::log(0.5) - lowest) / cells;
  double least = 1e300;
  for (double t = 1.5; t < 100; t *= 1.01) {
    double light = 0, rest = 0;
    for (int i = 0; i <= cells; ++i) {
      const double z = lowest + i * width, x = std::exp(z), log_rest = std::log1p(-x);
      const double simpson = i == 0 || i == cells ? 1 : i % 2 == 1 ? 4 : 2;
      const double weight =
          simpson * (std::exp(a * z + (b - 1) * log_rest) + std::exp(b * z + (a - 1) * log_rest));
      light += weight * std::exp(t * z);
      rest -= weight * std::expm1(t * log_rest);
    }
    least = std::min(least, t / std::log(rest / light));
  }
  return least;
}

TEST(BetaBalance, IsTheMinimumOfItsFormula) {
  for (const auto& [a, b] : std::vector<ramify::BetaSplit>{{0.01, 0.01}, {3, 0.2}}) {
    const double balance = beta_balance({a, b})->value;
    EXPECT_NEAR(balance, balance_on_a_grid(a, b), 1e-4 * balance) << a << " " << b;
    EXPECT_LE(balance, balance_on_a_grid(a, b) * (1 + 1e-9)) << a << " " << b;
  }
}

TEST(BetaBalance, TendsToItsLimits) {
  // Concentrated splits: X = p, 1/log(1/min(p,1-p)). Splits at the ends: a = b -> 0 has a limit too.
  EXPECT_NEAR(beta_balance({1e5, 1e5})->value, 1 / std::log(2.0), 5e-3);
  EXPECT_NEAR(beta_balance({2e4, 6e4})->value, 1 / std::log(4.0), 5e-3);
  EXPECT_NEAR(beta_balance({1e-9, 1e-9})->value, beta_balance({1e-12, 1e-12})->value, 1e-8);
  EXPECT_FALSE(beta_balance({1e6, 1}));
}

TEST(BalanceConstant, OfTheModels) {
  const auto value = [](const char* model) { return ramify::balance_constant(Model::parse(model))->value; };
  EXPECT_EQ(value("bst"), ramify::bst_balance().value);
  EXPECT_EQ(value("beta(2,5)"), beta_balance({2, 5})->value);
  EXPECT_NEAR(value("patricia(0.77)"), 0.6804220933, 1e-10);
  EXPECT_DOUBLE_EQ(value("split(1/2)"), 1 / std::log(2.0));
  EXPECT_FALSE(ramify::balance_constant(Model::parse("dst(0.2)")));
  EXPECT_FALSE(ramify::balance_constant(Model::parse("catalan")));
}

// F <= S <= B in every tree, and B <= H: so do the constants.
TEST(Constants, KeepTheOrderOfTheirStatistics) {
  for (const char* model : {"bst", "beta(0.1,0.1)", "beta(10,80)", "patricia(0.2)", "split(0.5)"}) {
    const auto known = ramify::constants(Model::parse(model));
    double previous = 0;
    for (const char* name : {"fill_level", "strahler", "balance", "height"})
      for (const auto& constant : known)
        if (constant.name == name) {
          EXPECT_GE(constant.value, previous * (1 - 1e-15)) << model << " " << name;
          previous = constant.value;
        }
  }
}

}  // namespace
