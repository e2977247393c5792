// The exact laws against values published, or computed by others, for one finite n: each to its printed
// digits. Larger n are in tests/cli/law_test.cpp. Depth and height count nodes here: one more than
// where edges and internal levels are counted.

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/columns.hpp"
#include "support/sanitized.hpp"
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/strahler.hpp"

namespace {

using ramify::ExactMeans;
using ramify::Model;
using ramify::OrderCount;
using ramify::Size;

struct Known {
  const char* model;
  const char* column;
  Size n;
  double mean;
  double digits;  // half a unit of the last one printed

  friend std::ostream& operator<<(std::ostream& out, const Known& known) {
    return out << known.column << " of " << known.model << ", n = " << known.n;
  }
};

class KnownMean : public testing::TestWithParam<Known> {};

TEST_P(KnownMean, IsMet) {
  const Known& known = GetParam();
  const auto exact =
      ExactMeans(Model::parse(known.model), known.n).moments(ramify::test::column(known.column), known.n);
  ASSERT_TRUE(exact);
  EXPECT_NEAR(exact->mean, known.mean, known.digits) << known.model << " " << known.column << " " << known.n;
}

const std::vector<Known> known_means{
    {"bst", "strahler", 3, 4.0 / 3, 1e-14},
    {"bst", "strahler", 5, 1.866667, 5e-7},
    {"bst", "strahler", 100, 4.220366, 5e-7},
    {"bst", "strahler", 579, 5.903625230898, 5e-13},
    {"bst", "strahler", 1000, 6.291212049411, 5e-13},
    {"bst", "strahler", 4096, 7.648916151611, 5e-13},
    {"catalan", "strahler", 10, 2.015956, 5e-7},
    {"catalan", "strahler", 579, 4.911280122962, 5e-13},
    {"catalan", "strahler", 1000, 5.235550504910, 5e-13},
    {"patricia(1/4.35)", "strahler", 10, 2.104855, 5e-7},
    {"patricia(1/4.35)", "strahler", 579, 5.029477, 5e-7},
    {"patricia(1/4.35)", "strahler", 2000, 6.004520, 5e-7},
    {"patricia(0.23)", "strahler", 579, 5.0298, 5e-5},
    {"dst(1/4.35)", "strahler", 10, 2.179458, 5e-7},
    {"dst(1/4.35)", "strahler", 579, 5.088462, 5e-7},
    {"dst(0.23)", "strahler", 579, 5.089242, 5e-7},
    {"dst(1/4.35)", "strahler", 2000, 6.020987, 5e-7},
    {"beta(10,10)", "strahler", 4096, 9.158269, 5e-7},
    {"beta_multinomial(10,10)", "strahler", 4096, 8.959290, 5e-7},
    {"split(1/4.35)", "strahler", 579, 5, 0},
    {"bst", "depth", 1000, 12.9709417211 + 1, 5e-11},
    {"bst", "depth", 4096, 15.7902077939 + 1, 5e-11},
    {"bst", "height", 1000, 22.0395060178 + 1, 5e-11},
    {"bst", "height", 4096, 27.6271299580 + 1, 5e-11},
    {"beta(10,10)", "height", 4096, 15.937 + 1, 5e-4},
    {"beta_multinomial(10,10)", "height", 4096, 17.320 + 1, 5e-4},
    {"patricia(0.5)", "height", 579, 12.3985 + 1, 5e-5},
    {"patricia(0.5)", "height", 4096, 15.9319 + 1, 5e-5},
    {"patricia(0.23)", "height", 579, 21.12 + 1, 5e-3},
    {"dst(0.23)", "height", 579, 19.99 + 1, 5e-3},
    {"bst", "fill_level", 1000, 4.119673712785, 5e-13},
    {"bst", "fill_level", 4096, 4.755718768527, 5e-13},
    {"bst", "balance", 10, 2.279048, 5e-7},
    {"bst", "balance", 100, 4.437107, 5e-7},
    {"bst", "balance", 1000, 6.711966244376, 5e-13},
    {"bst", "balance", 4096, 8.103136891224, 5e-13},
    {"catalan", "balance", 1000, 5.587713, 5e-7},
    {"dst(1/4.35)", "balance", 579, 5.211026, 5e-7},
    {"dst(1/4.35)", "streams_0", 579, 580, 1e-12},
    {"dst(1/4.35)", "streams_1", 579, 201.2269, 5e-5},
    {"dst(1/4.35)", "streams_2", 579, 64.4826, 5e-5},
    {"dst(1/4.35)", "streams_3", 579, 18.7627, 5e-5},
    {"dst(1/4.35)", "streams_4", 579, 5.1268, 5e-5},
    {"dst(1/4.35)", "streams_5", 579, 1.0895, 5e-5},
    {"dst(1/4.35)", "streams_6", 579, 0.0885, 5e-5},
    {"bst", "streams_1", 1000, 1001.0 / 3, 1e-10},
    {"catalan", "streams_1", 1000, 1000.0 * 1001 / (2 * 1999), 1e-10},
    {"split(1/4.35)", "streams_2", 579, 46, 0},
    {"split(1/4.35)", "nodes_3", 579, 35, 0},
    {"split(1/4.35)", "height", 579, 22, 0},
    {"split(0.25)", "height", 15, 8, 0},
};

INSTANTIATE_TEST_SUITE_P(Exact, KnownMean, testing::ValuesIn(known_means));

ramify::BoundedLaw strahler_law(const char* model, Size n) {
  return ramify::build_law(Model::parse(model), n, ramify::BoundedLaw(ramify::Strahler::recurrence, n));
}

TEST(KnownMean, OfCatalanOrdersAt4096) {
  // Above the reach of ExactMeans.
  EXPECT_NEAR(strahler_law("catalan", 4096).moments(4096).mean, 6.252966960333, 5e-13);
}

TEST(KnownLaw, OfBstOrders) {
  const auto law = strahler_law("bst", 4096);
  const std::array<double, 3> at_579{0.103712, 0.888951, 0.007337};
  for (std::size_t i = 0; i < at_579.size(); ++i) EXPECT_NEAR(law.pmf(579)[5 + i], at_579[i], 5e-7);
  EXPECT_NEAR(law.pmf(1000)[6], 0.707712, 5e-7);
  EXPECT_NEAR(law.pmf(1000)[7], 0.291750, 5e-7);
  EXPECT_NEAR(law.pmf(4096)[7], 0.351255, 5e-7);
  EXPECT_NEAR(law.pmf(4096)[8], 0.648566, 5e-7);
  // A small tail keeps its relative accuracy.
  EXPECT_NEAR(law.all_sizes(ramify::LawForm::from, 8)[1000], 2.06e-7, 5e-10);
}

TEST(KnownLaw, OfFairPatriciaOrders) {
  const auto law = strahler_law("patricia(0.5)", 10'000);
  EXPECT_NEAR(law.pmf(1000)[8], 0.999424, 5e-7);
  EXPECT_NEAR(law.pmf(4096)[10], 0.998424, 5e-7);
  EXPECT_NEAR(law.moments(10'000).variance, 1e-6, 5e-7);
}

// E B_n - (beta log n - c log log n) of the BST.
TEST(KnownMean, OfBstBalanceBeyondItsFirstTerms) {
  const auto law =
      ramify::build_law(Model::parse("bst"), 10'000, ramify::BoundedLaw(ramify::Balance::recurrence, 10'000));
  const std::vector<std::pair<Size, double>> printed{
      {100, 0.247}, {579, 0.284}, {1000, 0.301}, {4096, 0.310}, {10'000, 0.325}};
  for (const auto& [n, rest] : printed) {
    const double log_n = std::log(static_cast<double>(n));
    EXPECT_NEAR(law.moments(n).mean - 1.02624823037914 * log_n + 0.350654652619 * std::log(log_n), rest, 5e-4)
        << n;
  }
}

struct Slope {
  const char* model;
  double depth, height;
};

// (E X_4096 - E X_1000) / log 4.096.
TEST(KnownSlopes, OfDepthAndHeight) {
  if (ramify::test::sanitized) GTEST_SKIP() << "more of the laws of KnownMean, for a minute";
  for (const auto& [text, depth, height] :
       {Slope{"bst", 1.9995, 3.9628}, Slope{"beta(2,2)", 1.7136, 2.9916},
        Slope{"beta(10,10)", 1.4945, 2.0124}, Slope{"beta(0.1,0.1)", 7.4301, 18.568},
        Slope{"beta(1,5)", 2.6275, 6.1608}, Slope{"beta(10,80)", 2.9547, 8.4202}}) {
    const ExactMeans exact(Model::parse(text), 4096);
    const auto slope = [&exact](const char* column) {
      return (exact.moments(ramify::test::column(column), 4096)->mean -
              exact.moments(ramify::test::column(column), 1000)->mean) /
             std::log(4.096);
    };
    EXPECT_NEAR(slope("depth"), depth, 6e-5) << text;
    EXPECT_NEAR(slope("height"), height, 6e-5) << text;
  }
}

struct Thresholds {
  const char* model;
  std::vector<double> strings;

  friend std::ostream& operator<<(std::ostream& out, const Thresholds& known) { return out << known.model; }
};

class KnownThresholds : public testing::TestWithParam<Thresholds> {};

// The number of strings (n+1) at which P(S >= k) passes 1/2, k = 1, 2, ..., linear between whole numbers.
TEST_P(KnownThresholds, AreMet) {
  const auto& [model, strings] = GetParam();
  const auto largest = static_cast<Size>(strings.back()) + 1;
  const auto law = strahler_law(model, largest);
  for (std::size_t k = 1; k <= strings.size(); ++k) {
    const auto& reached = law.all_sizes(ramify::LawForm::from, static_cast<std::ptrdiff_t>(k));
    Size n = 0;
    while (reached[n + 1] < 0.5) ++n;
    const double threshold = static_cast<double>(n + 1) + (0.5 - reached[n]) / (reached[n + 1] - reached[n]);
    const double printed = strings[k - 1];
    EXPECT_NEAR(threshold, printed, printed > 4000 && printed == std::floor(printed) ? 0.5 : 0.051) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Patricia, KnownThresholds,
    testing::Values(
        Thresholds{"patricia(1/2)",
                   {1.5, 4.2, 10.9, 26.7, 62.2, 140.0, 308.2, 667.4, 1427.5, 3025.3, 6364.8, 13313}},
        Thresholds{"patricia(1/2.74)", {1.5, 4.3, 12.0, 33.1, 90.4, 246.8, 673.9, 1841.7, 5037, 13784}},
        Thresholds{"patricia(0.23)", {1.5, 4.7, 16.7, 63.3, 248.6, 1003.4, 4121, 17129}},
        Thresholds{"patricia(1/4.8)", {1.5, 4.8, 18.2, 73.9, 314.3, 1379.6, 6184}},
        Thresholds{"patricia(1/7.05)", {1.5, 5.4, 25.9, 138.2, 797.1, 4840}}));

TEST(KnownRatios, OfExpectedCountsOfPatricia) {
  const ExactMeans exact(Model::parse("patricia(1/4.35)"), 579);
  const std::array<double, 5> streams{3.045, 3.294, 3.581, 3.618, 4.336},
      nodes{1.656, 2.191, 3.103, 3.765, 3.570};
  const auto ratio = [&exact](const std::string& of, std::size_t k) {
    return exact.moments(ramify::test::column(of + std::to_string(k)), 579)->mean /
           exact.moments(ramify::test::column(of + std::to_string(k + 1)), 579)->mean;
  };
  for (std::size_t k = 0; k < streams.size(); ++k) {
    EXPECT_NEAR(ratio("streams_", k), streams[k], 5.1e-4) << k;
    EXPECT_NEAR(ratio("nodes_", k), nodes[k], 5.1e-4) << k;
  }
}

struct StreamRatios {
  const char* model;
  std::size_t first;  // order
  std::vector<double> ratios;
};

TEST(KnownRatios, OfExpectedStreamsOfMultinomialBetaTrees) {
  for (const auto& [text, first, ratios] :
       {StreamRatios{"beta_multinomial(10,10)", 5, {2.507, 2.502, 2.506}},
        StreamRatios{"beta_multinomial(0.1,0.1)", 0, {5.737, 3.725, 3.473, 3.396, 3.363}}}) {
    const auto orders = ramify::build_law(Model::parse(text), 4096, ramify::OrderMeans(4096));
    const auto streams = orders.streams(4096);
    for (std::size_t i = 0; i < ratios.size(); ++i)
      EXPECT_NEAR(streams[first + i] / streams[first + i + 1], ratios[i], 5e-4) << text << " " << first + i;
  }
}

TEST(KnownRatios, OfFairPatriciaOscillate) {
  const auto orders = ramify::build_law(Model::parse("patricia(0.5)"), 4096, ramify::OrderMeans(4096));
  EXPECT_NEAR(orders.streams(4096)[5] / orders.streams(4096)[6], 2.38, 0.005);
}

/// The delta method's standard deviation of M_k / M_(k+1) in one tree.
double deviation_of_ratio(const ramify::OrderMoments& law, Size n, std::size_t k) {
  const OrderCount a{OrderCount::Of::streams, k}, b{OrderCount::Of::streams, k + 1};
  const double mean_a = law.mean(n, a), mean_b = law.mean(n, b);
  const double relative = law.variance(n, a) / (mean_a * mean_a) + law.variance(n, b) / (mean_b * mean_b) -
                          2 * law.covariance(n, a, b) / (mean_a * mean_b);
  return mean_a / mean_b * std::sqrt(relative);
}

// Those values were sampled: they are right to about 1 %.
TEST(KnownDeviations, OfStreamRatios) {
  const std::vector<std::pair<const char*, std::array<double, 4>>> sampled{
      {"bst", {.060, .107, .188, .329}}, {"catalan", {.125, .252, .497, .924}}};
  for (const auto& [text, deviations] : sampled) {
    const Model model = Model::parse(text);
    const auto means = ramify::build_law(model, 1000, ramify::OrderMeans(1000));
    const auto law = ramify::build_law(model, 1000, ramify::OrderMoments(means, 1000));
    for (std::size_t k = 0; k < deviations.size(); ++k)
      EXPECT_NEAR(deviation_of_ratio(law, 1000, k) / deviations[k], 1, 0.012) << text << " " << k;
  }
}

}  // namespace
