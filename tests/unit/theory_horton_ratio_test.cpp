#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/law/exact_means.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/theory/beta_horton_ratio.hpp"
#include "ramify/theory/bst_horton_ratio.hpp"
#include "ramify/theory/gauss_jacobi.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"
#include "ramify/theory/horton_wave.hpp"
#include "ramify/theory/lattice_stencil.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace {

using ramify::beta_horton_ratio;
using ramify::Model;
using ramify::Precise;

// Computed apart in 34 digits: Taylor series of other unknowns, other steps, other extrapolation.
constexpr double bst_ratio = 3.043827861838666371571258;

TEST(GaussJacobi, IntegratesPolynomialsAgainstTheBetaDensity) {
  struct Weight {
    double alpha, beta;
  };
  for (const auto& [alpha, beta] :
       std::vector<Weight>{{0, 0}, {-0.5, -0.5}, {-0.9, 3}, {0.01, 0.19}, {10, 190}}) {
    const auto rule = ramify::gauss_jacobi(12, alpha, beta);
    double moment = 1;  // of X^power, X ~ beta(alpha+1, beta+1)
    for (int power = 0; power < 24; ++power) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      EXPECT_NEAR(sum, moment, 1e-13 * std::max(moment, 1e-3)) << alpha << " " << beta << " " << power;
      moment *= (alpha + 1 + power) / (alpha + beta + 2 + power);
    }
  }
}

TEST(LatticeStencil, ReproducesPolynomialsBetweenTheirPoints) {
  for (const double shift : {0.0, 0.5, -7.25, 3.999}) {
    const ramify::LatticeStencil stencil(shift);
    double sum = 0, magnitude = 0;
    for (int j = 0; j < ramify::LatticeStencil::width; ++j) {
      const double weight = stencil.weight[static_cast<std::size_t>(j)];
      sum += weight * std::pow((stencil.first + j) / 8.0, 15);
      magnitude += std::abs(weight);
    }
    EXPECT_NEAR(sum, std::pow(shift / 8, 15), 1e-10) << shift;
    EXPECT_LT(magnitude, 3) << shift;
  }
}

TEST(BstStreamDensities, MeetTheirClosedForms) {
  const auto densities = ramify::bst_stream_densities(3);
  const Precise e2 = exp(Precise(2));
  EXPECT_LT(static_cast<double>(abs(densities[0] * 3 - 1)), 1e-20);
  EXPECT_LT(static_cast<double>(abs(densities[1] / (e2 * e2 / 128 - e2 / 8 + Precise(233) / 384) - 1)),
            1e-20);
  EXPECT_NEAR(static_cast<double>(densities[2]), 0.036042311715201107, 1e-17);
}

TEST(BstHortonRatio, HasAllDigitsOfADouble) {
  const auto ratio = ramify::bst_horton_ratio();
  EXPECT_NEAR(ratio.value, bst_ratio, 5e-16);
  EXPECT_LE(ratio.error, 1e-15);
}

struct KnownRatio {
  double a, b;
  double ratio;
  double tolerance;  ///< one unit of the last digit printed

  friend std::ostream& operator<<(std::ostream& out, const KnownRatio& known) {
    return out << "a = " << known.a << ", b = " << known.b;
  }
};

class KnownHortonRatio : public testing::TestWithParam<KnownRatio> {};

TEST_P(KnownHortonRatio, IsMetWithinAnHonestError) {
  const auto& [a, b, known, tolerance] = GetParam();
  const auto ratio = beta_horton_ratio({a, b});
  ASSERT_TRUE(ratio) << a << " " << b;
  EXPECT_NEAR(ratio->value, known, ratio->error + tolerance) << a << " " << b;
  EXPECT_LE(ratio->error, 1e-8 * ratio->value) << a << " " << b;  // the digits that are promised
}

// Two of them are known otherwise: 4 of the uniform trees, and the BST's. The others were computed apart, by
// marching through the wave on two grids.
INSTANTIATE_TEST_SUITE_P(
    Theory, KnownHortonRatio,
    testing::Values(KnownRatio{-0.9, -0.9, 7.236705313124, 1e-12},
                    KnownRatio{-0.75, -0.75, 4.931645280152, 1e-12}, KnownRatio{-0.5, -0.5, 4, 0},
                    KnownRatio{0, 0, 3.425181982575, 1e-12}, KnownRatio{1, 1, bst_ratio, 0},
                    KnownRatio{0.5, 0.5, 3.185284085903, 1e-12}, KnownRatio{1, 2, bst_ratio, 0},
                    KnownRatio{2, 2, 2.875058914005, 1e-12}, KnownRatio{5, 5, 2.648212054664, 1e-12},
                    KnownRatio{10, 10, 2.496876977550, 1e-12}, KnownRatio{50, 50, 2.245572892273, 1e-12},
                    KnownRatio{100, 100, 2.175842333, 1e-9}, KnownRatio{0.1, 1, 3.347757967259, 1e-12},
                    KnownRatio{0.5, 1, 3.149892754670, 1e-12}, KnownRatio{1, 5, 3.587331613558, 1e-12},
                    KnownRatio{2, 5, 3.088171936496, 1e-12}, KnownRatio{2, 10, 3.935095051345, 1e-12},
                    KnownRatio{5, 20, 3.941416712583, 1e-12}, KnownRatio{10, 20, 2.912416372705, 1e-12},
                    KnownRatio{10, 23, 3.100298292084, 1e-12}, KnownRatio{23, 77, 3.975410035651, 1e-12},
                    KnownRatio{100, 400, 4.793467, 1e-6}));

TEST(BetaHortonRatio, ReachesTheCornersOfItsDomain) {
  for (const auto& [a, b] :
       std::vector<ramify::BetaSplit>{{10, 190}, {0.01, 0.01}, {0.01, 0.19}, {10, 80}, {190, 10}}) {
    const auto ratio = beta_horton_ratio({a, b});
    ASSERT_TRUE(ratio) << a << " " << b;
    EXPECT_LE(ratio->error, 1e-8 * ratio->value) << a << " " << b;
  }
}

TEST(BetaHortonRatio, DoesNotTellLeftFromRight) {
  EXPECT_EQ(beta_horton_ratio({2, 7})->value, beta_horton_ratio({7, 2})->value);
  EXPECT_EQ(beta_horton_ratio({-0.3, 0.4})->value, beta_horton_ratio({0.4, -0.3})->value);
}

TEST(BetaHortonRatio, IsTheSameForTheSameUnorderedSplit) {
  for (const double a : {-0.6, 0.3, 12.0}) {
    const auto even = beta_horton_ratio({a, a}), uneven = beta_horton_ratio({a, a + 1});
    EXPECT_NEAR(even->value, uneven->value, even->error + uneven->error) << a;
  }
}

TEST(BetaHortonRatio, IsLeftOutWhereNoLatticeHoldsTheWave) {
  EXPECT_FALSE(beta_horton_ratio({1e12, 1e12}));
  EXPECT_FALSE(beta_horton_ratio({1e-9, 1e9}));
}

// The exact law shares no code with the wave. From n / ratio to n it gains log(ratio) / log R orders on
// average, up to O(1/n): over a factor R the oscillation in log n drops out.
double gained(const ramify::ExactMeans& exact, double ratio) {
  const auto mean = [&exact](double n) {
    const auto below = static_cast<ramify::Size>(n);
    const double share = n - std::floor(n);
    return (1 - share) * exact.moments(ramify::statistic::strahler, below)->mean +
           share * exact.moments(ramify::statistic::strahler, below + 1)->mean;
  };
  const double largest = static_cast<double>(exact.largest_n() - 1);
  return mean(largest) - mean(largest / ratio);
}

TEST(HortonRatio, IsThatOfTheExactLaw) {
  for (const char* text : {"bst", "beta(2,2)", "beta(1,5)"}) {
    const Model model = Model::parse(text);
    const ramify::ExactMeans exact(model, 500);
    const double ratio = ramify::horton_ratio_constant(model)->value;
    EXPECT_NEAR(gained(exact, ratio), 1, 0.012) << text;
    EXPECT_GT(std::abs(gained(exact, ratio * 1.05) - 1), 0.018) << text;
    EXPECT_GT(std::abs(gained(exact, ratio / 1.05) - 1), 0.018) << text;
  }
}

TEST(HortonRatio, OfTheBstIsNotThree) {
  const ramify::ExactMeans exact(Model::parse("bst"), 1000);
  EXPECT_NEAR(gained(exact, bst_ratio), 1, 0.003);
  EXPECT_GT(std::abs(gained(exact, 3) - 1), 0.009);
}

// One order takes the front of the BST forward by log R from wherever it starts, and closer each time.
TEST(HortonWave, ComesCloserWithEveryOrder) {
  ramify::HortonWave wave({1, 1}, {0.1, 40, 40, 30});
  double miss = 1;
  for (int orders = 0; orders < 8; ++orders) {
    wave.advance();
    const double now = std::abs(std::exp(wave.log_ratio()) - bst_ratio);
    EXPECT_LT(now, miss);
    miss = now;
  }
  EXPECT_LT(miss, 1e-3);
}

TEST(HortonRatioConstant, OfTheModelsWithAClosedForm) {
  const auto value = [](const char* model) {
    return ramify::horton_ratio_constant(Model::parse(model))->value;
  };
  EXPECT_EQ(value("catalan"), 4);
  EXPECT_DOUBLE_EQ(value("patricia(0.8)"), 5);
  EXPECT_DOUBLE_EQ(value("split(0.25)"), 4);
  EXPECT_FALSE(ramify::horton_ratio_constant(Model::parse("dst(0.25)")));
  EXPECT_NE(ramify::horton_ratio_constant(Model::parse("catalan"))->formula.find("streams"),
            std::string::npos);
}

// Computed apart (docs/theory/horton-ratio.md); beta = 0 and -3/2 are known otherwise.
TEST(HortonRatioConstant, OfAldousTrees) {
  for (const auto& [model, ratio] :
       std::vector<std::pair<const char*, double>>{{"aldous(-1.9)", 7.236705313124},
                                                   {"aldous(-3/2)", 4},
                                                   {"aldous(-1)", 3.425181982575},
                                                   {"aldous(0)", bst_ratio},
                                                   {"aldous(1)", 2.875058914005}}) {
    const auto constant = ramify::horton_ratio_constant(Model::parse(model));
    ASSERT_TRUE(constant) << model;
    EXPECT_NEAR(constant->value, ratio, constant->error + 1e-12) << model;
    EXPECT_LE(constant->error, 1e-8 * ratio) << model;
    EXPECT_NEAR(ramify::strahler_constant(Model::parse(model))->value, 1 / std::log(ratio), 1e-8) << model;
  }
}

TEST(StrahlerConstant, IsOneOverTheLogarithmOfTheRatio) {
  const auto bst = ramify::strahler_constant(Model::parse("bst"));
  EXPECT_NEAR(bst->value, 0.89837905505563289, bst->error);
  EXPECT_LE(bst->error, 1e-14);
  const auto beta = ramify::strahler_constant(Model::parse("beta(1,1)"));
  EXPECT_NEAR(beta->value, bst->value, beta->error);
  EXPECT_LE(beta->error, 1e-11);
  for (const char* model : {"catalan", "patricia(0.23)", "split(0.4)"}) {
    const double ratio = ramify::horton_ratio_constant(Model::parse(model))->value;
    EXPECT_NEAR(ramify::strahler_constant(Model::parse(model))->value * std::log(ratio), 1, 1e-15) << model;
  }
}

}  // namespace
