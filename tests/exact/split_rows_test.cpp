#include "ramify/law/split_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

// The rows of a law are its pmf, folded: for beta that holds the quadrature against the incomplete betas.
TEST(SplitRows, AreTheFoldedPmf) {
  for (const char* text : {"bst",
                           "catalan",
                           "split(0.25)",
                           "dst(0.23)",
                           "patricia(0.77)",
                           "patricia(1e-9)",
                           "beta(2,2)",
                           "beta(0.01,0.01)",
                           "beta(10,80)",
                           "beta(0.3,5)",
                           "beta(1000,1000)",
                           "beta_multinomial(2,2)",
                           "beta_multinomial(0.01,0.01)",
                           "beta_multinomial(1e-9,1e-9)",
                           "beta_multinomial(0.3,5)",
                           "beta_multinomial(1000,1000)",
                           "aldous(-1.9)",
                           "aldous(-1)",
                           "aldous(-0.3)",
                           "aldous(7)",
                           "ford(0.3)",
                           "ford(0.8)",
                           "ford(1)",
                           "complete",
                           "chain"}) {
    const Model model = Model::parse(text);
    SplitRows rows(model);
    for (const Size n : {1u, 2u, 3u, 17u, 100u, 1001u}) {
      const auto row = rows.row(n);
      auto pmf = n == 1 ? std::vector<double>{1} : split_pmf(model, n);
      for (Size i = (n + 1) / 2; i < n; ++i) pmf[n - 1 - i] += pmf[i];
      long double sum = 0;
      for (std::size_t m = 0; m < row.weights.size(); ++m) {
        sum += row.weights[m];
        const double truth = pmf[row.smaller(m)];
        if (truth <= 1e-15) continue;
        EXPECT_NEAR(row.weights[m] / truth, 1, 1e-10) << text << " n = " << n << " m = " << m;
      }
      EXPECT_NEAR(static_cast<double>(sum), 1, 1e-14) << text << " n = " << n;
    }
  }
}

/// Of a row: the weight of every size of the smaller child.
std::vector<double> smaller_sizes(const Model& model, Size n) {
  SplitRows rows(model);
  const auto row = rows.row(n);
  std::vector<double> weights(n, 0.0);
  for (std::size_t m = 0; m < row.weights.size(); ++m) weights[row.smaller(m)] = row.weights[m];
  return weights;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, std::abs(one[i] - other[i]));
  return largest;
}

// (f(x) + f(1-x))/2 is the same for beta(a,a+1) and beta(a,a), so at every size the splits are
// the same up to left and right, and with them the law of every statistic that does not tell these apart.
TEST(SplitRows, OfBetaWithOneMoreOnTheRightAreThoseOfTheSymmetricBeta) {
  for (const char* kind : {"beta", "beta_multinomial"})
    for (const double a : {0.05, 0.5, 1.0, 2.5, 10.0, 200.0})
      for (const Size n : {2u, 3u, 10u, 101u, 1000u}) {
        const auto row = [&](double b) {
          return smaller_sizes(Model::parse(fmt::format("{}({},{})", kind, a, b)), n);
        };
        const auto even = row(a);
        EXPECT_LT(largest_difference(row(a + 1), even), 1e-12) << kind << ' ' << a << ' ' << n;
        if (n >= 10) {  // at n = 3 and a = 200 nearly every split is the even one
          EXPECT_GT(largest_difference(row(a + 2), even), 1e-8) << kind << ' ' << a << ' ' << n;
        }
      }
}

// Several passes over kept rows read what one pass computed, whether the model keeps them or not.
TEST(StoredSplitRows, AreTheRows) {
  for (const char* text : {"bst", "catalan", "beta(2,5)", "dst(0.3)"}) {
    const Model model = Model::parse(text);
    SplitRows rows(model);
    StoredSplitRows stored(model);
    for (int pass = 0; pass < 2; ++pass) {
      for (Size n = 1; n <= 60; ++n) {
        const auto row = rows.row(n), kept = stored.row(n);
        EXPECT_EQ(kept.n, n);
        EXPECT_EQ(kept.first, row.first) << text << ' ' << n;
        EXPECT_EQ(std::vector<double>(kept.weights.begin(), kept.weights.end()),
                  std::vector<double>(row.weights.begin(), row.weights.end()))
            << text << ' ' << n;
      }
    }
  }
}

}  // namespace
}  // namespace ramify
