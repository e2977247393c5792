// The splits of large aldous and ford trees, far above the sizes whose Gamma functions fit into a double:
// against closed forms, and what a draw costs.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <boost/math/special_functions/digamma.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/model/aldous.hpp"
#include "ramify/model/catalan.hpp"
#include "ramify/model/ford.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t draws = test::replicates(200'000);

/// P(left < k), k <= n/2.
using Below = std::function<double(Size n, Size k)>;

/// beta = -1: weights 1/j + 1/(m-j) over j = 1..k.
double below_harmonic(Size n, Size k) {
  const auto harmonic = [](Size j) { return boost::math::digamma(static_cast<double>(j) + 1); };
  const double h_0 = boost::math::digamma(1.0);
  return (harmonic(k) - h_0 + harmonic(n) - harmonic(n - k)) / (2 * (harmonic(n) - h_0));
}

/// beta = -3/2, as Catalan inverts it.
double below_catalan(Size n, Size k) {
  const auto g = Catalan::central_binomial;
  const double size = static_cast<double>(n);
  const double level = (size - 2 * static_cast<double>(k)) / size * g(k) * g(n - k) / g(n);
  return (1 - level) / 2;
}

double below_uniform(Size n, Size k) {
  return static_cast<double>(k) / static_cast<double>(n);
}

/// beta = 1: weights (j+1) (m-j+1), j = 1..k.
double below_parabola(Size n, Size k) {
  const auto sum = [m = static_cast<double>(n) + 1](double j) {
    return j * (m + 1) + m * j * (j + 1) / 2 - j * (j + 1) * (2 * j + 1) / 6;
  };
  return sum(static_cast<double>(k)) / sum(static_cast<double>(n));
}

/// Where cells of doubling width end, from 1 to n/2.
std::vector<Size> cell_ends(Size n) {
  std::vector<Size> ends;
  for (Size k = 1; k < n / 2; k *= 2) ends.push_back(k);
  ends.push_back(n / 2);
  return ends;
}

/// Of both sides: left in a cell, or right in it. n even.
std::vector<double> cell_law(Size n, const Below& below) {
  std::vector<double> left;
  double last = 0;
  for (const Size end : cell_ends(n)) {
    const double now = below(n, end);
    left.push_back(now - std::exchange(last, now));
  }
  std::vector<double> both(left);
  both.insert(both.end(), left.rbegin(), left.rend());
  return both;
}

template <class Law>
std::vector<std::uint64_t> count_cells(const Law& law, Size n, const std::string& tag) {
  const auto ends = cell_ends(n);
  const auto cell = [&ends](Size i) {
    return static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), i) - ends.begin());
  };
  std::vector<std::uint64_t> counts(2 * ends.size(), 0);
  Stream stream({test::seed_of(tag), n}, 0);
  for (std::uint64_t i = 0; i < draws; ++i) {
    const Size left = law.left(n, stream);
    EXPECT_LT(left, n);
    ++counts.at(left < n / 2 ? cell(left) : counts.size() - 1 - cell(n - 1 - left));
  }
  return counts;
}

void expect_law(double beta, Size n, const Below& below) {
  const auto law = cell_law(n, below);
  const auto what = fmt::format("aldous({}) at n = {}", beta, n);
  EXPECT_TRUE(test::agrees(test::chi_square(what, count_cells(Aldous(beta), n, what), law)));
  const double wrong = beta + std::max(0.1, (beta + 2) / 10);
  const auto slip = fmt::format("aldous({}) for aldous({}) at n = {}", wrong, beta, n);
  EXPECT_TRUE(test::rejected(test::chi_square(slip, count_cells(Aldous(wrong), n, slip), law)));
}

class AldousSplit : public testing::TestWithParam<Size> {};

TEST_P(AldousSplit, MeetsItsClosedForms) {
  const Size n = GetParam();
  expect_law(-1.5, n, below_catalan);
  expect_law(-1, n, below_harmonic);
  expect_law(0, n, below_uniform);
  expect_law(1, n, below_parabola);
}

INSTANTIATE_TEST_SUITE_P(Sizes, AldousSplit,
                         testing::Values(200, 1'000'000, 1'000'000'000, 1'000'000'000'000'000),
                         testing::PrintToStringParamName());

TEST(AldousSplits, AreThePmfAtAMillion) {
  constexpr Size n = 1'000'000;
  for (const double beta : {-1.97, -1.7, -1.25, -1.02, -0.98, -0.75, -0.5, -0.25, -0.01, 0.5, 4.0}) {
    const auto pmf = split_pmf(Aldous(beta), n);
    std::vector<double> sums{0};
    for (Size i = 0; i < n / 2; ++i) sums.push_back(sums.back() + pmf[i]);
    expect_law(beta, n, [&sums](Size, Size k) { return sums[k]; });
  }
}

void expect_ford(double alpha, Size n, const Below& below) {
  const auto law = cell_law(n, below);
  const auto what = fmt::format("ford({}) at n = {}", alpha, n);
  EXPECT_TRUE(test::agrees(test::chi_square(what, count_cells(Ford(alpha), n, what), law)));
  const double wrong = alpha < 0.5 ? alpha + 0.03 : alpha - 0.03;
  const auto slip = fmt::format("ford({}) for ford({}) at n = {}", wrong, alpha, n);
  EXPECT_TRUE(test::rejected(test::chi_square(slip, count_cells(Ford(wrong), n, slip), law)));
}

TEST_P(AldousSplit, IsAlsoFordsAtItsEnds) {
  expect_ford(0, GetParam(), below_uniform);
  expect_ford(0.5, GetParam(), below_catalan);
}

TEST(FordSplits, AreThePmfAtAMillion) {
  constexpr Size n = 1'000'000;
  for (const double alpha : {0.01, 0.2, 0.4, 0.49, 0.51, 0.7, 0.95}) {
    const auto pmf = split_pmf(Ford(alpha), n);
    std::vector<double> sums{0};
    for (Size i = 0; i < n / 2; ++i) sums.push_back(sums.back() + pmf[i]);
    expect_ford(alpha, n, [&sums](Size, Size k) { return sums[k]; });
  }
}

/// P(left = 0) and P(left = 1) in closed form, one node or two.
std::vector<double> ford_end_law(double alpha, Size n) {
  const double m = static_cast<double>(n) + 1;
  const double none = (alpha * m / 2 + 1 - 2 * alpha) / (m - 1 - alpha);
  const double one =
      (1 - alpha) / (m - 1 - alpha) * (alpha / 4 * m * (m - 1) + (1 - 2 * alpha) * (m - 2)) / (m - 2 - alpha);
  return {none, one, 1 - 2 * none - 2 * one, one, none};
}

std::vector<std::uint64_t> count_ends(const Ford& law, Size n, const std::string& tag) {
  std::vector<std::uint64_t> counts(5, 0);
  Stream stream({test::seed_of(tag), n}, 0);
  for (std::uint64_t i = 0; i < draws; ++i) {
    const Size left = law.left(n, stream);
    ++counts[left < 2 ? left : n - 1 - left < 2 ? 4 - (n - 1 - left) : 2];
  }
  return counts;
}

TEST(FordSplits, HaveTheEndsOfTheFormulaAtEverySize) {
  for (const double alpha : {0.1, 0.3, 0.6, 0.9})
    for (const Size n : {Size{200}, Size{1'000'000'000}, Size{1} << 50}) {
      const auto law = ford_end_law(alpha, n);
      const auto what = fmt::format("ends of ford({}) at n = {}", alpha, n);
      EXPECT_TRUE(test::agrees(test::chi_square(what, count_ends(Ford(alpha), n, what), law)));
      const auto slip = what + ", slip";
      EXPECT_TRUE(test::rejected(test::chi_square(slip, count_ends(Ford(alpha + 0.02), n, slip), law)));
    }
}

/// A stream that counts the words taken.
struct CountingStream {
  using result_type = Stream::result_type;
  static constexpr result_type min() { return Stream::min(); }
  static constexpr result_type max() { return Stream::max(); }
  result_type operator()() {
    ++words;
    return stream();
  }
  Stream stream;
  std::uint64_t words = 0;
};

// Rejection costs three words a try.
TEST(InnerFraction, AcceptsMostOfItsTries) {
  constexpr std::uint64_t fractions = 20000;
  double least = 1;
  for (const double a :
       {-0.9999999, -0.99, -0.9, -0.75, -0.5, -0.25, -0.01, 0.0, 0.01, 0.25, 0.5, 0.75, 0.99})
    for (const Size n : {Size{2}, Size{3}, Size{5}, Size{129}, Size{1000000}, Size{1} << 50}) {
      CountingStream stream{Stream({test::seed_of("inner fraction"), n}, 0)};
      for (std::uint64_t i = 0; i < fractions; ++i) InnerFraction(a, n)(stream);
      const double accepted = 3 * static_cast<double>(fractions) / static_cast<double>(stream.words);
      EXPECT_GT(accepted, n < 4 ? 0.4 : 0.58) << "a = " << a << ", n = " << n;
      least = std::min(least, accepted);
    }
  fmt::print("least acceptance {:.3f}\n", least);
}

// Whatever beta and n, a draw takes a bounded number of words on average.
TEST(LargeSplits, TakeFewWords) {
  constexpr std::uint64_t splits = 20000;
  double most = 0;
  for (const double beta : {-1.9999999999999998, -1.9, -1.5, -1.0, -0.5, -1e-9, 0.0, 1.0, 1e3, 1e300})
    for (const Size n : {Size{2}, Size{129}, Size{1000000}, Size{1} << 50}) {
      CountingStream stream{Stream({test::seed_of("words of a split"), n}, 0)};
      for (std::uint64_t i = 0; i < splits; ++i) Aldous(beta).left(n, stream);
      most = std::max(most, static_cast<double>(stream.words) / static_cast<double>(splits));
    }
  EXPECT_LT(most, 16);
  for (const double alpha : {0.0, 1e-9, 0.3, 0.5, 0.6, 0.9999999, 1.0})
    for (const Size n : {Size{2}, Size{129}, Size{1000000}, Size{1} << 50}) {
      CountingStream stream{Stream({test::seed_of("words of a ford split"), n}, 0)};
      for (std::uint64_t i = 0; i < splits; ++i) Ford(alpha).left(n, stream);
      most = std::max(most, static_cast<double>(stream.words) / static_cast<double>(splits));
    }
  // Up to three tries of two or three draws each.
  EXPECT_LT(most, 32);
  fmt::print("most words a split {:.1f}\n", most);
}

}  // namespace
}  // namespace ramify
