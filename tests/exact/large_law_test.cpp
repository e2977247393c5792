// Laws on a grid of sizes, held against the recurrences over all sizes where these reach, against closed
// forms and asymptotic expansions beyond.
#include "ramify/large/large_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "support/columns.hpp"
#include "support/sanitized.hpp"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "ramify/large/compressed_rows.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

const std::vector<std::string>& models() {
  static const std::vector<std::string> list{
      "bst",        "beta(2,2)", "beta(10,80)",    "beta(0.5,0.5)", "beta_multinomial(0.5,0.5)",
      "aldous(-1)", "catalan",   "patricia(0.23)", "patricia(0.5)", "dst(0.23)",
      "ford(0.3)"};
  return list;
}

const StatisticInfo& named(std::string_view name) {
  return *std::ranges::find_if(statistics(), [name](const StatisticInfo& info) { return info.name == name; });
}

// ---- rows ----

class CompressedRow : public testing::TestWithParam<std::string> {};

/// Means over the splits of functions that are smooth, that have a kink at ties, and that tell the parity of
/// a child.
TEST_P(CompressedRow, SumsLikeTheWholeRow) {
  const Model model = Model::parse(GetParam());
  const CompressedRows rows(model, 0.04, 1e9);
  SplitRows whole(model);
  for (const Size n : {1024u, 1025u, 1026u, 1027u, 3000u}) {
    const auto compared = [&](std::optional<Residue> residue, auto g) {
      double exact = 0, compressed = 0;
      const SplitRow row = whole.row(n);
      for (std::size_t m = 0; m < row.weights.size(); ++m)
        exact += row.weights[m] *
                 g(static_cast<double>(row.smaller(m) + 1), static_cast<double>(row.larger(m) + 1));
      const auto leaves = static_cast<double>(n + 1);
      for (const SplitPlace& place : rows.row(leaves, residue).places)
        compressed += place.weight * g(place.smaller, leaves - place.smaller);
      EXPECT_NEAR(compressed / exact, 1, 3e-9) << n;
    };
    const auto residue = static_cast<Residue>(n % residues);
    compared(std::nullopt, [](double x, double y) { return std::log(x) * std::log(y); });
    compared(residue, [](double x, double y) { return std::log(x) * std::log(y); });
    compared(residue, [](double x, double y) { return std::abs(x - y); });
    compared(residue, [](double x, double y) { return std::min(x, y) / std::max(x, y); });
  }
}

TEST_P(CompressedRow, SumsToOneAtEverySize) {
  const CompressedRows rows(Model::parse(GetParam()), 0.04, 1e300);
  for (const double leaves : {1e3, 1e4, 1e6, 1e9, 1e15, 1e30, 1e100, 1e300}) {
    const auto row = rows.row(leaves);
    EXPECT_LT(row.lost, 1e-11) << leaves;
    EXPECT_LT(row.places.size(), 3000u) << leaves;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, CompressedRow, testing::ValuesIn(models()));

// ---- laws ----

constexpr Size exact_to = 4100;  // twice the table from which the grid begins

class LargeLawOf : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  Model model() const { return Model::parse(std::get<0>(GetParam())); }
  const StatisticInfo& statistic() const { return named(std::get<1>(GetParam())); }
  bool tells_ties() const { return statistic().name == "balance"; }
  /// A law of ties is known to the fourth residue of n; where many splits are ties, that is the least.
  double wanted() const {
    if (!tells_ties()) return 1e-9;
    return std::get<0>(GetParam()) == "patricia(0.5)" ? 3e-6 : 1e-7;
  }
};

/// One law of every kind is enough for the sanitizers.
bool is_left_to_the_release_build(const std::string& model) {
  return test::sanitized && model != "patricia(0.5)";
}

TEST_P(LargeLawOf, IsTheExactOneWithinItsError) {
  if (is_left_to_the_release_build(std::get<0>(GetParam()))) GTEST_SKIP();
  const Recurrence& recurrence = statistic().law.recurrence;
  const StatisticLaw exact = build_law(model(), exact_to, StatisticLaw(recurrence, exact_to));
  const LargeLaw large(model(), recurrence, {static_cast<double>(exact_to)});
  for (const Size n : {Size{2100}, Size{3001}, Size{4096}, exact_to - 1, exact_to}) {
    const Moments known = exact.moments(n);
    const LargeMoments found = large.moments(static_cast<double>(n));
    const double mean_scale = std::max(1.0, std::abs(known.mean)),
                 variance_scale = std::max(1.0, known.variance);
    EXPECT_NEAR(found.mean.value, known.mean, wanted() * mean_scale) << n;
    EXPECT_NEAR(found.variance.value, known.variance, wanted() * variance_scale) << n;
    // The exact law itself is right to 1e-13.
    EXPECT_NEAR(found.mean.value, known.mean, found.mean.error + 1e-12 * mean_scale) << n;
    EXPECT_NEAR(found.variance.value, known.variance, found.variance.error + 2e-12 * variance_scale) << n;
    const auto law = exact.law(n);
    if (!law) continue;
    const LargeFiniteLaw values = *large.law(static_cast<double>(n));
    for (std::size_t i = 0; i < law->probabilities.size(); ++i) {
      const double at = law->first + static_cast<double>(i) - values.first;
      const bool is_known = at >= 0 && at < static_cast<double>(values.probabilities.size());
      const double p = is_known ? values.probabilities[static_cast<std::size_t>(at)].value : 0;
      EXPECT_NEAR(p, law->probabilities[i], tells_ties() ? wanted() : 1e-9)
          << n << ' ' << law->first + static_cast<double>(i);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, LargeLawOf,
                         testing::Combine(testing::ValuesIn(models()),
                                          testing::Values("strahler", "height", "fill_level", "balance",
                                                          "external_depth", "depth", "sackin", "colless")));

class LargeOrdersOf : public testing::TestWithParam<std::string> {};

TEST_P(LargeOrdersOf, HaveTheExactMeans) {
  if (is_left_to_the_release_build(GetParam())) GTEST_SKIP();
  const Model model = Model::parse(GetParam());
  const OrderMeans exact = build_law(model, exact_to, OrderMeans(exact_to));
  const LargeOrders large(model, {static_cast<double>(exact_to)});
  for (const Size n : {Size{2100}, Size{4096}, exact_to}) {
    const double leaves = static_cast<double>(n + 1);
    for (const auto of : {OrderCount::Of::nodes, OrderCount::Of::streams}) {
      const auto known = of == OrderCount::Of::nodes ? exact.nodes(n) : exact.streams(n);
      const auto found = large.means(static_cast<double>(n), of);
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].value, known[k], 1e-9 * leaves) << n << ' ' << k;
        EXPECT_NEAR(found[k].value, known[k], found[k].error + 1e-12 * leaves) << n << ' ' << k;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, LargeOrdersOf, testing::ValuesIn(models()));

// ---- far beyond ----

/// E S of the uniform binary tree: over p of the sums over j of C(2n, n+1-J) - 2 C(2n, n-J) + C(2n, n-1-J), J
/// = j 2^p, over C_n (theory of the register function; Flajolet, Raoult and Vuillemin 1979).
double catalan_mean_order(double n) {
  using Precise = boost::multiprecision::cpp_bin_float_50;
  const Precise size = n;
  // C(2n, n-m) / C(2n, n) = prod over i = 1..m of (n-m+i)/(n+i), by Stirling's series; m << n.
  const auto log_factorial = [](const Precise& x) {
    const Precise t = 1 / (x * x);
    return (x + Precise(1) / 2) * log(x) - x + (Precise(1) / 12 - t * (Precise(1) / 360 - t / 1260)) / x;
  };
  const auto ratio = [&](double m) {
    return exp(2 * log_factorial(size) - log_factorial(size - m) - log_factorial(size + m));
  };
  Precise mean = 0;
  for (double power = 2; power <= n; power *= 2) {
    Precise tail = 0;
    if (power * power < n / 100) {  // 1 but for e^(-pi^2 n / power^2)
      mean += 1;
      continue;
    }
    for (double m = power; m < 12 * std::sqrt(n); m += power)
      tail += ratio(m - 1) - 2 * ratio(m) + ratio(m + 1);
    mean += tail * (size + 1);  // C(2n, n) = (n+1) C_n
  }
  return static_cast<double>(mean);
}

TEST(LargeLaw, OfCatalansOrderIsItsClosedForm) {
  if (test::sanitized) GTEST_SKIP() << "as much of the code as LargeLawOf, for longer";
  const LargeLaw law(Model::parse("catalan"), Strahler::recurrence, {1e12, 1e15});
  for (const double n : {1e6, 1e12, 1e15}) {
    const Approximation mean = law.moments(n).mean;
    const double known = catalan_mean_order(n);
    EXPECT_NEAR(mean.value, known, 1e-9 * known) << n;
    EXPECT_NEAR(mean.value, known, mean.error + 1e-12) << n;
  }
}

/// log_R n + C and three harmonics, of period 1 in log_R n; right to 1e-7 from 1e9 on.
double bst_mean_order(double n) {
  const double x = std::log(n) / std::log(3.043827861838666371571258), turn = 2 * std::numbers::pi * x;
  return x + 0.13641420177 + 0.0629052970 * std::cos(turn + 2.43380897) +
         0.000408502684 * std::cos(2 * turn - 2.66602140) + 2.462e-6 * std::cos(3 * turn - 2.93716);
}

TEST(LargeLaw, OfTheBstsOrderIsALineWithItsHarmonics) {
  if (test::sanitized) GTEST_SKIP() << "as much of the code as LargeLawOf, for longer";
  const double ratio = 3.043827861838666371571258;
  const LargeLaw law(Model::parse("bst"), Strahler::recurrence, {1e9, 1e9 * ratio, 1e18, 1e18 * ratio});
  for (const double n : {1e9, 1e18}) {
    EXPECT_NEAR(law.moments(n).mean.value, bst_mean_order(n), 1e-6) << n;
    EXPECT_NEAR(law.moments(n * ratio).mean.value - law.moments(n).mean.value, 1, 1e-8) << n;
  }
}

TEST(LargeLaw, KeepsItsErrorsSmallAtABillion) {
  if (test::sanitized) GTEST_SKIP() << "as much of the code as LargeLawOf, for longer";
  for (const char* model : {"bst", "beta_multinomial(0.5,0.5)", "patricia(0.23)", "dst(0.23)"})
    for (const char* statistic : {"strahler", "fill_level", "sackin"}) {
      const LargeMoments m =
          LargeLaw(Model::parse(model), named(statistic).law.recurrence, {1e9}).moments(1e9);
      EXPECT_LT(m.mean.error, 1e-7 * std::max(1.0, m.mean.value)) << model << ' ' << statistic;
      EXPECT_LT(m.variance.error, 1e-7 * std::max(1.0, m.variance.value)) << model << ' ' << statistic;
    }
}

TEST(LargeLaw, EndsWhereSplitsAreKnownAtWholeSizesAlone) {
  for (const char* model : {"split(0.25)", "complete", "chain"})
    EXPECT_NE(no_large_laws(Model::parse(model)), "") << model;
  EXPECT_NE(no_large_laws(Model::parse("patricia(1e-6)")), "");
  for (const std::string& model : models()) EXPECT_EQ(no_large_laws(Model::parse(model)), "") << model;
}

}  // namespace
}  // namespace ramify
