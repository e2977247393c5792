// Small probabilities and small mean counts of the exact laws against the recurrences as they read, in long
// double, with positive terms only and nothing cut off.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "support/sanitized.hpp"
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace {

using ramify::Model;
using ramify::Size;

using Real = long double;
using Table = std::vector<std::vector<Real>>;

constexpr double promised = 1e-20;  // smaller ones may have fewer digits

/// P(left = i), scaled to sum 1.
std::vector<Real> split_law(const Model& model, Size n) {
  if (n == 1) return {1};
  const auto pmf = split_pmf(model, n);
  const Real sum = std::accumulate(pmf.begin(), pmf.end(), Real{0});
  std::vector<Real> scaled;
  for (const double p : pmf) scaled.push_back(p / sum);
  return scaled;
}

/// P(H_n > h) and P(H_n <= h), at [n][h], h = 0..top.
struct HeightTails {
  Table above, at_most;
};

HeightTails height_tails(const Model& model, Size largest, Size top) {
  HeightTails tails{Table(largest + 1, std::vector<Real>(top + 1, 0)), {}};
  tails.at_most = tails.above;
  tails.above[0][0] = 1;
  for (Size h = 1; h <= top; ++h) tails.at_most[0][h] = 1;
  for (Size n = 1; n <= largest; ++n) {
    const auto left = split_law(model, n);
    tails.above[n][0] = 1;
    for (Size i = 0; i < n; ++i) {
      const auto &above_a = tails.above[i], &at_most_a = tails.at_most[i];
      const auto &above_b = tails.above[n - 1 - i], &at_most_b = tails.at_most[n - 1 - i];
      for (Size h = 1; h <= top; ++h) {
        tails.above[n][h] += left[i] * (above_a[h - 1] + at_most_a[h - 1] * above_b[h - 1]);
        tails.at_most[n][h] += left[i] * at_most_a[h - 1] * at_most_b[h - 1];
      }
    }
  }
  return tails;
}

/// Relative, wherever digits are promised.
void expect_digits(double value, Real truth, double tolerance) {
  if (truth >= promised) {
    EXPECT_NEAR(static_cast<double>(value / truth), 1, tolerance) << static_cast<double>(truth);
  } else {
    EXPECT_LE(value, 1.01 * promised);
  }
}

void expect_height_law(const ramify::HeightLaw& law, const HeightTails& tails, Size n, Size top) {
  const auto pmf = law.pmf(n);
  const Size lowest = law.lowest(n);
  const auto at = [&](Size h) { return h < lowest || h - lowest >= pmf.size() ? 0 : pmf[h - lowest]; };
  for (Size h = 1; h <= top; ++h) {
    SCOPED_TRACE(testing::Message() << "n = " << n << ", height " << h);
    expect_digits(law.above(n, h), tails.above[n][h], 1e-12);
    expect_digits(law.at_most(n, h), tails.at_most[n][h], 1e-12);
    // Of two neighbouring tails; one that hardly falls leaves fewer digits to the difference.
    const bool low = tails.at_most[n][h] < 0.5L;
    const auto& tail = low ? tails.at_most[n] : tails.above[n];
    const Real larger = std::max(tail[h - 1], tail[h]), truth = std::abs(tail[h] - tail[h - 1]);
    if (larger >= promised) {
      EXPECT_NEAR(at(h), static_cast<double>(truth), static_cast<double>(1e-12L * larger));
    }
  }
  EXPECT_NEAR(std::accumulate(pmf.begin(), pmf.end(), 0.0), 1, 4e-15) << n;
}

class HeightDigits : public testing::TestWithParam<std::string> {};

TEST_P(HeightDigits, AreTwelveInBothTails) {
  constexpr Size largest = 400, top = 250;
  const Model model = Model::parse(GetParam());
  const auto law = ramify::build_law(model, largest, ramify::HeightLaw());
  const HeightTails tails = height_tails(model, largest, top);
  for (const Size n : {0u, 1u, 2u, 7u, 50u, 187u, 399u, 400u}) expect_height_law(law, tails, n, top);
}

INSTANTIATE_TEST_SUITE_P(Models, HeightDigits,
                         testing::Values("bst", "catalan", "patricia(0.23)", "patricia(0.5)", "dst(0.23)",
                                         "dst(0.02)", "beta_multinomial(0.5,0.5)", "aldous(-1)", "ford(0.7)",
                                         "split(0.25)", "complete", "chain"));

// Unlikely heights of small trees, far below 1e-20, make those of large ones: of P(H = 54) 1.5e-4.
TEST(HeightLaw, OfAThousandNodesKeepsItsUpperTail) {
  constexpr Size n = 1000, top = 110;
  const Model bst = Model::parse("bst");
  const auto law = ramify::build_law(bst, n, ramify::HeightLaw());
  const HeightTails tails = height_tails(bst, n, top);
  expect_height_law(law, tails, n, top);
}

/// P(H_n <= h) of a bst alone, h = 0..top.
Table low_heights(Size largest, Size top) {
  Table at_most(top + 1, std::vector<Real>(largest + 1, 0));  // [h][n]
  for (Size h = 1; h <= top; ++h) {
    at_most[h][0] = 1;
    for (Size n = 1; n <= largest && n < Size{1} << (h - 1); ++n) {
      const Real* before = at_most[h - 1].data();
      for (Size i = 0; i < n; ++i) at_most[h][n] += before[i] * before[n - 1 - i];
      at_most[h][n] /= static_cast<Real>(n);
    }
  }
  return at_most;
}

// 1 - P(H > h) stood for the lower tail: 5.418e-14 for 6.159e-14, and more at heights that never occur.
TEST(HeightLaw, OfThousandsOfNodesKeepsItsLowerTail) {
  if (ramify::test::sanitized) GTEST_SKIP() << "smaller sizes run the same code";
  constexpr Size n = 8192, top = 24;
  const auto law = ramify::build_law(Model::parse("bst"), n, ramify::HeightLaw());
  const Table at_most = low_heights(n, top);
  for (const Size size : {3000u, 8192u}) {
    const auto pmf = law.pmf(size);
    const Size lowest = law.lowest(size);
    for (Size h = 15; h <= top; ++h) {
      SCOPED_TRACE(testing::Message() << size << " nodes, height " << h);
      expect_digits(h < lowest ? 0 : pmf[h - lowest], at_most[h][size] - at_most[h - 1][size], 1e-12);
    }
    EXPECT_NEAR(std::accumulate(pmf.begin(), pmf.end(), 0.0), 1, 4e-15);
  }
  EXPECT_NEAR(law.at_most(n, 23) - law.at_most(n, 22), 6.159e-14, 5e-18);
}

/// P(S_n = k), E N_k(n) and E M_k(n), at [n][k].
struct OrderTables {
  Table order, nodes, streams;
};

OrderTables order_tables(const Model& model, Size largest) {
  const std::size_t top = ramify::HortonStrahler::largest_order(largest);
  OrderTables t{Table(largest + 1, std::vector<Real>(top + 1, 0)), {}, {}};
  t.order[0][0] = 1;
  t.nodes = t.streams = t.order;
  for (Size n = 1; n <= largest; ++n) {
    const auto left = split_law(model, n);
    for (Size i = 0; i < n; ++i) {
      const Size j = n - 1 - i;
      Real below_i = 0, below_j = 0;
      for (std::size_t k = 0; k <= top; ++k) {
        const Real born = k == 0 ? 0 : left[i] * t.order[i][k - 1] * t.order[j][k - 1];
        t.order[n][k] += left[i] * (t.order[i][k] * below_j + below_i * t.order[j][k]) + born;
        t.nodes[n][k] += left[i] * (t.nodes[i][k] + t.nodes[j][k]);
        t.streams[n][k] += left[i] * (t.streams[i][k] + t.streams[j][k]) + born;
        below_i += t.order[i][k];
        below_j += t.order[j][k];
      }
    }
    for (std::size_t k = 0; k <= top; ++k) t.nodes[n][k] += t.order[n][k];
  }
  return t;
}

class OrderDigits : public testing::TestWithParam<std::string> {};

TEST_P(OrderDigits, AreThirteenOfEveryMeanCount) {
  constexpr Size largest = 600;
  const Model model = Model::parse(GetParam());
  const auto law = ramify::build_law(model, largest, ramify::OrderMeans(largest));
  const OrderTables truth = order_tables(model, largest);
  for (Size n = 1; n <= largest; ++n) {
    const auto nodes = law.nodes(n), streams = law.streams(n), order = law.strahler().pmf(n);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      SCOPED_TRACE(testing::Message() << "n = " << n << ", order " << k);
      expect_digits(nodes[k], truth.nodes[n][k], 1e-13);
      expect_digits(streams[k], truth.streams[n][k], 1e-13);
      expect_digits(order[k], truth.order[n][k], 1e-13);
    }
  }
}

// Rare splits made the loss with dst and patricia, rare orders with the others.
INSTANTIATE_TEST_SUITE_P(Models, OrderDigits,
                         testing::Values("bst", "catalan", "patricia(0.01)", "patricia(0.23)", "dst(0.05)",
                                         "ford(0.9)", "aldous(-1.9)", "beta_multinomial(0.5,0.5)"));

}  // namespace
