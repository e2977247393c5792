// The law of the stream counts of ternary trees against all trees of small sizes, against a published mean
// and against trees that are grown; the bounds of their order against that law.
#include "ternary_orders.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/uninterrupted.hpp"
#include "support/word_law.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

/// Of every tree of a law, by definition.
StreamCounts counts_of_words(const test::WordLaw& law, std::size_t orders) {
  StreamCounts counts;
  counts.means.resize(orders);
  counts.order_tail.resize(orders + 1);
  counts.covariances.resize(orders * orders);
  for (const auto& [word, probability] : law) {
    const test::Shape shape = test::read_shape(word);
    auto streams = test::streams_per_order(shape);
    streams.resize(orders);
    for (std::size_t s = 0; s <= test::strahler(shape); ++s) counts.order_tail[s] += probability;
    for (std::size_t k = 0; k < orders; ++k) {
      counts.means[k] += probability * static_cast<double>(streams[k]);
      for (std::size_t j = 0; j < orders; ++j)
        counts.covariances[j * orders + k] += probability * static_cast<double>(streams[j] * streams[k]);
    }
  }
  for (std::size_t k = 0; k < orders; ++k)
    for (std::size_t j = 0; j < orders; ++j)
      counts.covariances[j * orders + k] -= counts.means[j] * counts.means[k];
  return counts;
}

double farthest_apart(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  return std::transform_reduce(
      a.begin(), a.end(), b.begin(), 0.0, [](double x, double y) { return std::max(x, y); },
      [](double x, double y) { return std::abs(x - y); });
}

double off_all_trees(const std::string& model, unsigned n, const test::WordLaw& law) {
  const StreamCounts found = ternary_stream_counts(Model::parse(model), n, test::uninterrupted);
  const StreamCounts all = counts_of_words(law, found.orders());
  return std::max({farthest_apart(found.means, all.means), farthest_apart(found.order_tail, all.order_tail),
                   farthest_apart(found.covariances, all.covariances)});
}

TEST(TernaryStreamCounts, AreThoseOfAllTreesOfSmallSizes) {
  const auto constant = [](double) { return 0.25; };
  for (unsigned n = 1; n <= 9; ++n)
    EXPECT_LT(off_all_trees("ternary(0.25)", n, test::ternary_law(constant, n)), 1e-12) << n;
  EXPECT_GT(off_all_trees("ternary(0.26)", 9, test::ternary_law(constant, 9)), 1e-3);
}

TEST(TernaryStreamCounts, AreThoseOfAllTreesWhereTheSplitDependsOnTheDepth) {
  const auto maple = [](double depth) { return 1 / (3.19 + std::log(depth)); };
  for (unsigned n = 1; n <= 8; ++n)
    EXPECT_LT(off_all_trees("node_ternary(1/(3.19+log(d)))", n, test::ternary_law(maple, n)), 1e-12) << n;
  EXPECT_GT(off_all_trees("node_ternary(1/(3.19+log(d+1)))", 8, test::ternary_law(maple, 8)), 1e-3)
      << "the root has depth 1";
}

// A22: exact, made apart from the library.
TEST(TernaryStreamCounts, HaveThePublishedOrderOfTheWhiteFir) {
  const StreamCounts fir = ternary_stream_counts(Model::parse("ternary(1/4.8)"), 1000, test::uninterrupted);
  EXPECT_NEAR(std::accumulate(fir.order_tail.begin() + 1, fir.order_tail.end(), 0.0), 5.500746, 5e-7);
  EXPECT_EQ(fir.means.front(), 2001);
}

TEST(TernaryStreamCounts, AreTheSameWhereAFormulaSaysNoMoreThanANumber) {
  const auto number = ternary_stream_counts(Model::parse("ternary(0.2)"), 60, test::uninterrupted);
  const auto formula = ternary_stream_counts(Model::parse("node_ternary(0.2)"), 60, test::uninterrupted);
  EXPECT_LT(farthest_apart(number.means, formula.means), 1e-12);
  EXPECT_LT(farthest_apart(number.covariances, formula.covariances), 1e-10);
}

// The chance that they leave out is that of all nodes together, so the law keeps them with room.
TEST(TernaryOrdersLeft, HoldOfTheExactLaw) {
  constexpr double chance = 1e-3;
  for (const char* text : {"ternary(1/4.8)", "ternary(1/3.19)", "ternary(1/7.05)"}) {
    const Model model = Model::parse(text);
    for (const Size n : {Size{1}, Size{2}, Size{30}, Size{300}}) {
      const auto tail = ternary_stream_counts(model, n, test::uninterrupted).order_tail;
      const auto [lower, upper] =
          ternary_orders_left(model.parameters().front(), static_cast<double>(n), chance);
      const auto least = static_cast<std::size_t>(lower), above = static_cast<std::size_t>(upper) + 1;
      EXPECT_GE(tail.at(least), 1 - chance) << text << ' ' << n;
      EXPECT_LE(above < tail.size() ? tail[above] : 0, chance) << text << ' ' << n;
    }
  }
}

TEST(TernaryOrdersLeft, CloseInOnTheGrowthConstant) {
  const double p = 1 / 4.8, constant = 1 / std::log(4.8);
  double last_width = 1;
  for (const double n : {1e50, 1e100, 1e200, 1e300}) {
    const auto [lower, upper] = ternary_orders_left(p, n, 1e-3);
    EXPECT_LE(lower, constant * std::log(n));
    EXPECT_GE(upper, constant * std::log(n));
    const double width = (upper - lower) / std::log(n);
    EXPECT_LT(width, last_width);
    last_width = width;
  }
  EXPECT_LT(last_width, 0.03);
}

}  // namespace
}  // namespace ramify
