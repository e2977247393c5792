#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/sanitized.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/theory/constants.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/fill_level_constant.hpp"
#include "ramify/theory/height_constant.hpp"
#include "ramify/theory/precise.hpp"
#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/split_variance.hpp"
#include "ramify/theory/strahler_constant.hpp"

namespace {

using ramify::Constant;
using ramify::Model;
using ramify::Precise;

std::optional<Constant> find(const std::string& model, const std::string& name) {
  for (auto& constant : ramify::constants(Model::parse(model)))
    if (constant.name == name) return constant;
  return std::nullopt;
}

struct Known {
  const char* model;
  const char* name;
  double value;
  double tolerance;

  friend std::ostream& operator<<(std::ostream& out, const Known& known) {
    return out << known.name << " of " << known.model;
  }
};

class KnownConstant : public testing::TestWithParam<Known> {};

TEST_P(KnownConstant, IsMet) {
  const Known& known = GetParam();
  const auto constant = find(known.model, known.name);
  ASSERT_TRUE(constant) << known.model << " " << known.name;
  EXPECT_NEAR(constant->value, known.value, known.tolerance) << known.model << " " << known.name;
  EXPECT_LT(constant->error, 1e-12 * constant->value);
}

// Computed apart, by quadrature and mpmath; tolerance: one unit of the last digit printed there.
const std::vector<Known> known_constants{
    {"bst", "depth", 2, 0},
    {"bst", "height", 4.31107040700100504, 1e-15},
    {"bst", "strahler", 0.89837905505563289, 2e-15},
    {"bst", "horton_ratio", 3.043827861838666371571258, 5e-16},
    {"bst", "fill_level", 0.373364617701674084, 1e-16},
    {"bst", "balance", 1.02624823037913934, 3e-16},
    {"beta(2,2)", "depth", 12.0 / 7, 1e-15},
    {"beta(2,2)", "height", 3.192582835094, 1e-12},
    {"beta(2,2)", "fill_level", 0.5660777121, 1e-10},
    {"beta(5,5)", "depth", 1.548862937922, 1e-12},
    {"beta(5,5)", "height", 2.411555486301, 1e-12},
    {"beta(5,5)", "fill_level", 0.8151750149, 1e-10},
    {"beta(10,10)", "depth", 1.495279246767, 1e-12},
    {"beta(10,10)", "height", 2.083655370773, 1e-12},
    {"beta(10,10)", "fill_level", 0.9710354760, 1e-10},
    {"beta(100,100)", "depth", 1.447904196034, 1e-12},
    {"beta(100,100)", "height", 1.624650695521, 1e-12},
    {"beta(100,100)", "fill_level", 1.2775466031, 1e-10},
    {"beta(0.5,0.5)", "depth", 2.588699449562, 1e-12},
    {"beta(0.5,0.5)", "height", 6.380903816762, 1e-12},
    {"beta(0.1,0.1)", "depth", 7.423075936080, 1e-12},
    {"beta(0.1,0.1)", "height", 22.13991140784, 1e-11},
    {"beta(0.01,0.01)", "depth", 62.12666760393, 1e-11},
    {"beta(0.01,0.01)", "height", 197.7783951597, 1e-10},
    {"beta(0.01,0.01)", "fill_level", 0.0048150753, 1e-10},
    {"beta(1,2)", "height", 4.31107040700100504, 1e-15},  // the same unordered split as beta(1,1)
    {"beta(1,3)", "depth", 2.181818181818, 1e-12},
    {"beta(1,3)", "height", 5.012842756341, 1e-12},
    {"beta(1,5)", "depth", 2.627737226277, 1e-12},
    {"beta(1,5)", "height", 6.789596506587, 1e-12},
    {"beta(1,10)", "depth", 3.755588673621, 1e-12},
    {"beta(1,10)", "height", 11.61849254502, 1e-11},
    {"beta(2,5)", "depth", 1.875, 1e-15},
    {"beta(2,5)", "height", 3.869422253396, 1e-12},
    {"beta(5,20)", "depth", 2.078570871169, 1e-12},
    {"beta(5,20)", "height", 4.808997481343, 1e-12},
    {"beta(10,20)", "depth", 1.612457784772, 1e-12},
    {"beta(10,20)", "height", 2.727874865987, 1e-12},
    {"beta(10,80)", "depth", 2.912307565053, 1e-12},
    {"beta(80,10)", "depth", 2.912307565053, 1e-12},
    {"beta(10,80)", "height", 8.634818523321, 1e-12},
    {"beta(80,10)", "height", 8.634818523321, 1e-12},
    {"beta(10,80)", "fill_level", 0.4271822186, 1e-10},
    {"beta(10,80)", "balance", 0.5275720393, 1e-10},
    {"beta(20,80)", "depth", 2.018382772075, 1e-12},
    {"beta(20,80)", "height", 4.579441911896, 1e-12},
    {"patricia(1/2)", "depth", 1.4426950409, 1e-10},
    {"patricia(1/2)", "height", 1.4426950409, 1e-10},
    {"patricia(0.23)", "depth", 1.8543368641, 1e-10},
    {"patricia(0.77)", "depth", 1.8543368641, 1e-10},
    {"patricia(0.23)", "height", 3.8260704472, 1e-10},
    {"patricia(0.77)", "height", 3.8260704472, 1e-10},
    {"patricia(0.23)", "strahler", 0.6804220933, 1e-10},
    {"patricia(0.23)", "horton_ratio", 4.3478260869565217, 1e-15},
    {"patricia(0.77)", "fill_level", 0.6804220933, 1e-10},
    {"patricia(0.77)", "balance", 0.6804220933, 1e-10},
    {"dst(1/7.05)", "depth", 2.4491989646, 1e-10},
    {"dst(1/7.05)", "height", 6.5372575233, 1e-10},
    {"split(1/4.8)", "height", 4.2805497807, 1e-10},
    {"split(1/4.8)", "strahler", 0.6375046871, 1e-10},
    {"catalan", "strahler", 0.72134752044448170368, 2e-16},
    {"catalan", "horton_ratio", 4, 0},
    {"beta(10,80)", "split_mean", 1.0 / 9, 1e-16},
    {"beta(10,80)", "split_variance", 800.0 / (8100 * 91), 1e-18},
    {"beta_multinomial(1,1)", "height", 4.31107040700100504, 1e-15},
    {"beta_multinomial(10,80)", "depth", 2.912307565053, 1e-12},
    {"beta_multinomial(10,80)", "height", 8.634818523321, 1e-12},
    {"beta_multinomial(10,80)", "fill_level", 0.4271822186, 1e-10},
    {"beta_multinomial(10,80)", "balance", 0.5275720393, 1e-10},
    {"beta_multinomial(10,80)", "split_mean", 1.0 / 9, 1e-16},
    {"beta_multinomial(10,80)", "split_variance", 800.0 / (8100 * 91), 1e-18},
    {"aldous(0)", "depth", 2, 1e-15},
    {"aldous(1)", "height", 3.192582835094, 1e-12},
    {"aldous(-0.5)", "fill_level", 0.2176279414, 1e-10},
    {"aldous(0)", "balance", 1.02624823037913934, 1e-12},
    {"aldous(1)", "split_mean", 0.5, 0},
    {"aldous(1)", "split_variance", 0.05, 1e-17},
    {"complete", "depth", 1.4426950408889634, 2e-16},
    {"complete", "height", 1.4426950408889634, 2e-16},
    {"complete", "strahler", 1.4426950408889634, 2e-16},
    {"complete", "fill_level", 1.4426950408889634, 2e-16},
    {"complete", "balance", 1.4426950408889634, 2e-16},
    {"complete", "horton_ratio", 2, 0},
    {"bst", "split_mean", 0.5, 0},
    {"bst", "split_variance", 1.0 / 12, 1e-17},
};

INSTANTIATE_TEST_SUITE_P(Theory, KnownConstant, testing::ValuesIn(known_constants));

// The minimum taken in the plainest way: log-gammas in double precision, t on a fine grid.
double height_on_a_grid(double a, double b) {
  double least = 1e300;
  for (double t = 1.01; t < 400; t *= 1.0005) {
    const double both = std::lgamma(a + b) - std::lgamma(a + b + t);
    const double moment = std::exp(both + std::lgamma(a + t) - std::lgamma(a)) +
                          std::exp(both + std::lgamma(b + t) - std::lgamma(b));
    if (moment < 1) least = std::min(least, -t / std::log(moment));
  }
  return least;
}

TEST(HeightConstant, IsTheMinimumOfItsFormula) {
  for (const auto& [a, b] :
       std::vector<std::pair<double, double>>{{1000, 1000}, {100, 400}, {0.5, 7}, {10, 80}, {3, 2}}) {
    const auto model = Model::parse("beta(" + std::to_string(a) + "," + std::to_string(b) + ")");
    const double height = ramify::height_constant(model)->value;
    EXPECT_NEAR(height, height_on_a_grid(a, b), 1e-6 * height) << model.text();
    EXPECT_LE(height, height_on_a_grid(a, b) * (1 + 1e-10)) << model.text();
  }
}

/// The text is not the double: it may lie half a unit of its last place off.
TEST(Constants, HaveBoundsThatHoldOfThePrintedDecimals) {
  for (const auto& [a, b] : std::vector<std::pair<double, double>>{
           {0.07, 3}, {0.01, 50}, {0.3, 0.7}, {2, 3}, {10, 80}, {0.1, 0.1}}) {
    const Precise x = a, y = b;
    const Precise mean = x / (x + y), variance = mean * (1 - mean) / (x + y + 1);
    for (const auto& [name, truth] : {std::pair{"split_mean", mean}, std::pair{"split_variance", variance}}) {
      const auto constant = find(fmt::format("beta({},{})", a, b), name);
      const Precise printed(fmt::format("{}", constant->value)),
          bound(fmt::format("{:.10g}", constant->error));
      EXPECT_LE(abs(printed - truth), bound) << name << ' ' << a << ' ' << b;
      EXPECT_LE(constant->error, 3e-16 * constant->value);
    }
  }
}

TEST(Constants, HoldAtTheEndsOfTheParameters) {
  if (ramify::test::sanitized) GTEST_SKIP() << "other parameters run the same code";
  // 1/mu: as a = b -> 0 with s = a+b, mu -> s zeta(2) / 2 to first order; as a = b -> infinity it tends to
  // log 2.
  EXPECT_NEAR(find("beta(1e-9,1e-9)", "depth")->value * 1e-9 * std::numbers::pi * std::numbers::pi / 6, 1,
              1e-8);
  EXPECT_NEAR(find("beta(1e9,1e9)", "depth")->value * std::numbers::ln2, 1, 1e-8);
  double mu = 0;  // psi(2001) - psi(1001)
  for (int k = 2000; k > 1000; --k) mu += 1.0 / k;
  EXPECT_NEAR(find("beta(1000,1000)", "depth")->value, 1 / mu, 1e-14);
  for (const char* model :
       {"beta(1e-9,1e-9)", "beta(1e9,1e9)", "beta(1e-9,1e9)", "patricia(1e-300)", "dst(0.999999999999)"})
    for (const auto& constant : ramify::constants(Model::parse(model))) {
      EXPECT_TRUE(std::isfinite(constant.value)) << model << " " << constant.name;
      const bool by_the_wave = constant.name == "strahler" || constant.name == "horton_ratio";
      EXPECT_LE(constant.error, (by_the_wave ? 1e-8 : 1e-12) * constant.value)
          << model << " " << constant.name;
    }
}

std::vector<std::string> names(const char* model) {
  std::vector<std::string> names;
  for (const auto& constant : ramify::constants(Model::parse(model))) names.push_back(constant.name);
  return names;
}

TEST(Constants, AreListedInTheOrderOfTheTable) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("bst"), (Names{"depth", "height", "strahler", "horton_ratio", "fill_level", "balance",
                                 "split_mean", "split_variance"}));
  EXPECT_EQ(names("beta(2,5)"), names("bst"));
  EXPECT_EQ(names("beta_multinomial(2,5)"), names("bst"));
  EXPECT_EQ(names("patricia(0.2)"), names("bst"));
  EXPECT_EQ(names("split(0.2)"), names("bst"));
  EXPECT_EQ(names("dst(0.2)"), (Names{"depth", "height", "split_mean", "split_variance"}));
  for (const char* model : {"catalan", "aldous(-1)", "aldous(-1.25)"})
    EXPECT_EQ(names(model), (Names{"strahler", "horton_ratio"})) << model;
  EXPECT_EQ(names("aldous(-0.5)"), names("bst"));
  EXPECT_EQ(names("complete"),
            (Names{"depth", "height", "strahler", "horton_ratio", "fill_level", "balance"}));
  for (const char* model : {"chain", "ford(0.3)", "ford(1)"}) EXPECT_EQ(names(model), Names{}) << model;
  EXPECT_EQ(names("ford(0)"), names("bst"));
  EXPECT_EQ(names("ford(1/2)"), names("catalan"));
}

TEST(Constants, SaysWhereTheyComeFrom) {
  for (const char* model : {"bst", "beta(2,5)", "beta_multinomial(2,5)", "split(0.2)", "dst(0.2)",
                            "patricia(0.2)", "catalan", "aldous(-1)", "aldous(1)", "complete"})
    for (const auto& constant : ramify::constants(Model::parse(model))) {
      EXPECT_FALSE(constant.formula.empty()) << model << " " << constant.name;
      EXPECT_FALSE(constant.source.empty()) << model << " " << constant.name;
    }
}

}  // namespace
