#if defined(__GNUC__) && !defined(__clang__)
// GCC 12 takes a limb that Boost's rational constructor fills for one that it reads.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "support/growing.hpp"
#include "support/reference_laws.hpp"
#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/model/registry.hpp"

namespace ramify {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

std::vector<double> pmf_of(const std::string& model, Size n) {
  return split_pmf(Model::parse(model), n);
}

cpp_int choose(unsigned n, unsigned k) {
  cpp_int result = 1;
  for (unsigned i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

double to_double(const cpp_rational& ratio) {
  return static_cast<double>(ratio);
}

/// Relative agreement; below 1e-290 a double has lost digits of its own.
void expect_same_law(const std::vector<double>& law, const std::vector<double>& exact, double tolerance) {
  ASSERT_EQ(law.size(), exact.size());
  for (std::size_t i = 0; i < law.size(); ++i) {
    if (exact[i] < 1e-290) {
      EXPECT_LT(law[i], 1e-280) << "left = " << i;
    } else {
      EXPECT_NEAR(law[i] / exact[i], 1, tolerance) << "left = " << i << " of n = " << law.size();
    }
  }
}

TEST(SplitLaw, SumsToOneForEveryModel) {
  for (const auto& model : test::all_models()) {
    for (const Size n : {1u, 2u, 3u, 10u, 100u, 128u, 1000u, 5000u}) {
      const auto law = pmf_of(model, n);
      ASSERT_EQ(law.size(), n);
      long double sum = 0;
      for (const double p : law) {
        EXPECT_GE(p, 0);
        sum += p;
      }
      EXPECT_NEAR(static_cast<double>(sum), 1, 1e-14) << model << " at n = " << n;
    }
  }
}

TEST(BstLaw, IsUniform) {
  for (const Size n : {1u, 2u, 7u, 1000u})
    for (const double p : pmf_of("bst", n)) EXPECT_EQ(p, 1 / static_cast<double>(n));
}

TEST(CatalanLaw, IsTheProductOfCatalanNumbers) {
  const auto catalan = [](unsigned i) { return cpp_int(choose(2 * i, i) / (i + 1)); };
  for (const unsigned n : {1u, 2u, 3u, 4u, 10u, 50u, 128u, 200u}) {
    std::vector<double> exact;
    for (unsigned i = 0; i < n; ++i)
      exact.push_back(to_double(cpp_rational(catalan(i) * catalan(n - 1 - i), catalan(n))));
    expect_same_law(pmf_of("catalan", n), exact, 1e-13);
  }
  expect_same_law(pmf_of("catalan", 3), {0.4, 0.2, 0.4}, 1e-15);
}

// p = a/64 is exact in binary, so the law is a ratio of integers.
TEST(DstLaw, IsBinomialInRationals) {
  for (const unsigned n : {1u, 2u, 3u, 10u, 60u, 128u}) {
    for (const unsigned a : {1u, 15u, 32u, 63u}) {
      const cpp_int left = a, right = 64 - a, all = pow(cpp_int(64), n - 1);
      std::vector<double> exact;
      for (unsigned i = 0; i < n; ++i) {
        const cpp_rational share(choose(n - 1, i) * pow(left, i) * pow(right, n - 1 - i), all);
        exact.push_back(to_double(share));
      }
      expect_same_law(pmf_of(fmt::format("dst({}/64)", a), n), exact, 1e-12);
    }
  }
}

TEST(PatriciaLaw, IsTheInnerBinomialInRationals) {
  for (const unsigned n : {1u, 2u, 3u, 10u, 60u, 128u}) {
    for (const unsigned a : {1u, 15u, 32u, 63u}) {
      const cpp_int left = a, right = 64 - a;
      const cpp_int inner = pow(cpp_int(64), n + 1) - pow(left, n + 1) - pow(right, n + 1);
      std::vector<double> exact;
      for (unsigned i = 0; i < n; ++i)
        exact.push_back(
            to_double(cpp_rational(choose(n + 1, i + 1) * pow(left, i + 1) * pow(right, n - i), inner)));
      expect_same_law(pmf_of(fmt::format("patricia({}/64)", a), n), exact, 1e-12);
    }
  }
}

// A13: for n = 3 and p = 1/2 the law is 4/14, 6/14, 4/14 against 1/4, 1/2, 1/4 of the DST.
TEST(PatriciaLaw, DiffersFromTheDst) {
  expect_same_law(pmf_of("patricia(1/2)", 3), {4.0 / 14, 6.0 / 14, 4.0 / 14}, 1e-14);
  expect_same_law(pmf_of("dst(1/2)", 3), {0.25, 0.5, 0.25}, 1e-14);
}

TEST(BinomialLaws, HoldAtLargeSizes) {
  for (const double p : {0.001, 0.23, 0.5, 0.99}) {
    expect_same_law(pmf_of(fmt::format("dst({})", p), 5000), test::dst_law(5000, p), 1e-12);
    expect_same_law(pmf_of(fmt::format("patricia({})", p), 5000), test::patricia_law(5000, p), 1e-12);
  }
}

TEST(BetaLaw, OfOneOneIsTheBst) {
  for (const Size n : {1u, 2u, 3u, 10u, 128u, 1000u})
    expect_same_law(pmf_of("beta(1,1)", n), pmf_of("bst", n), 1e-11);
}

// Whole a, b: I_x(a,b) = P(Bin(a+b-1, x) >= a), a ratio of integers at x = i/n.
TEST(BetaLaw, IsABinomialTailForWholeParameters) {
  const std::vector<std::pair<unsigned, unsigned>> shapes{{1, 1}, {2, 3}, {3, 2}, {10, 80}, {10, 10}, {1, 5}};
  for (const auto& [a, b] : shapes) {
    for (const unsigned n : {2u, 3u, 10u, 40u}) {
      const unsigned m = a + b - 1;
      std::vector<cpp_int> below(n + 1, 0);  // I_(i/n)(a,b) n^m
      for (unsigned i = 0; i <= n; ++i)
        for (unsigned k = a; k <= m; ++k)
          below[i] += choose(m, k) * pow(cpp_int(i), k) * pow(cpp_int(n - i), m - k);
      std::vector<double> exact;
      for (unsigned i = 0; i < n; ++i)
        exact.push_back(to_double(cpp_rational(below[i + 1] - below[i], pow(cpp_int(n), m))));
      expect_same_law(pmf_of(fmt::format("beta({},{})", a, b), n), exact, 1e-10);
    }
  }
}

TEST(BetaLaw, IsTheIntegralOfItsDensity) {
  const std::vector<std::pair<double, double>> shapes{{0.01, 0.01}, {0.1, 0.1}, {0.5, 3},    {0.3, 0.2},
                                                      {0.01, 1000}, {10, 0.1},  {1000, 1000}};
  for (const auto& [a, b] : shapes) {
    const Model model = Model::parse(fmt::format("beta({},{})", a, b));
    for (const Size n : {2u, 3u, 10u, 128u, 1000u}) {
      SCOPED_TRACE(model.text());
      expect_same_law(split_pmf(std::get<Beta>(model.law()), n), test::beta_law(n, a, b), 1e-10);
    }
  }
}

TEST(BetaMultinomialLaw, OfOneOneIsTheBst) {
  for (const Size n : {1u, 2u, 3u, 10u, 128u, 5000u})
    expect_same_law(pmf_of("beta_multinomial(1,1)", n), pmf_of("bst", n), 1e-15);
}

// The reference is a product of rising factorials in 50 digits and is not scaled to sum 1.
TEST(BetaMultinomialLaw, IsPolyasUrn) {
  const std::vector<std::pair<double, double>> shapes{{0.01, 0.01}, {0.01, 0.02}, {0.1, 0.1}, {0.5, 3},
                                                      {0.3, 0.2},   {1, 0.4},     {2, 5},     {0.01, 1000},
                                                      {1000, 1000}, {80, 10}};
  for (const auto& [a, b] : shapes)
    for (const Size n : {1u, 2u, 3u, 10u, 128u, 1000u, 20000u}) {
      SCOPED_TRACE(fmt::format("a = {}, b = {}", a, b));
      expect_same_law(split_pmf(BetaMultinomial(a, b), n), test::beta_multinomial_law(n, a, b), 1e-11);
    }
}

// As X concentrates, the digital search tree: of 39 left, 39^2/2a = 2.5e-6 is left at a = 3e8.
TEST(BetaMultinomialLaw, TendsToTheBinomial) {
  expect_same_law(pmf_of("beta_multinomial(3e8,7e8)", 40), pmf_of("dst(0.3)", 40), 3e-6);
}

TEST(AldousLaw, OfZeroIsTheBstToTheLastBit) {
  for (const Size n : {1u, 2u, 3u, 10u, 128u, 5000u})
    expect_same_law(pmf_of("aldous(0)", n), pmf_of("bst", n), 1e-15);
}

TEST(AldousLaw, IsTheProductOfGammaQuotients) {
  for (const double beta : {-1.9999999, -1.9, -1.5, -1.1, -1.0, -0.7, -0.5, -1e-9, 0.3, 1.0, 50.0, 1e6})
    for (const Size n : {1u, 2u, 3u, 10u, 128u, 1000u, 20000u}) {
      SCOPED_TRACE(fmt::format("beta = {}, n = {}", beta, n));
      expect_same_law(split_pmf(Aldous(beta), n), test::aldous_law(n, beta), 1e-11);
    }
}

// At the sizes where Gamma functions in double precision have long overflowed (n = 172).
TEST(AldousLaw, KeepsItsDigitsAtAMillion) {
  constexpr Size n = 1'000'000;
  expect_same_law(split_pmf(Aldous(-1.5), n), split_pmf(Catalan(), n), 1e-10);
  std::vector<double> harmonic(n);
  long double sum = 0;  // of 1/k, k = 1..n
  for (Size k = n; k >= 1; --k) sum += 1 / static_cast<long double>(k);
  for (Size k = 1; k <= n; ++k) {
    const auto left = static_cast<long double>(k), right = static_cast<long double>(n + 1 - k);
    harmonic[k - 1] = static_cast<double>((left + right) / (2 * sum * left * right));
  }
  expect_same_law(split_pmf(Aldous(-1), n), harmonic, 1e-10);
}

// The reference is not scaled to sum 1.
TEST(FordLaw, IsItsFormula) {
  for (const double alpha : {0.0, 1e-9, 0.1, 0.3, 0.5, 0.7, 0.9, 0.9999999, 1.0})
    for (const Size n : {1u, 2u, 3u, 10u, 128u, 1000u, 20000u}) {
      SCOPED_TRACE(fmt::format("alpha = {}, n = {}", alpha, n));
      expect_same_law(split_pmf(Ford(alpha), n), test::ford_law(n, alpha), 1e-11);
    }
}

TEST(FordLaw, KeepsItsDigitsAtAMillion) {
  constexpr Size n = 1'000'000;
  expect_same_law(split_pmf(Ford(0.5), n), split_pmf(Catalan(), n), 1e-10);
  expect_same_law(split_pmf(Ford(0), n), split_pmf(Bst(), n), 1e-10);
}

TEST(CompleteLaw, IsTheHeap) {
  for (const Size n : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 12u, 100u, 1023u, 1024u})
    EXPECT_EQ(pmf_of("complete", n), test::complete_law(n));
}

TEST(ChainLaw, IsACoinToss) {
  for (const Size n : {1u, 2u, 3u, 100u}) EXPECT_EQ(pmf_of("chain", n), test::chain_law(n));
}

// Where the product in double precision falls on the wrong side of a whole number: 100 * 0.29, 49 * (1/49).
TEST(FixedSplitLaw, IsTheFloorOfTheFractionAsWritten) {
  struct Written {
    const char* text;
    unsigned numerator, denominator;
  };
  for (const auto& [text, numerator, denominator] :
       {Written{"0.29", 29, 100}, Written{"0.57", 57, 100}, Written{"0.58", 58, 100}, Written{"1/49", 1, 49},
        Written{"0.3", 3, 10}, Written{"0.7", 7, 10}, Written{"1/4.35", 20, 87}}) {
    const Model model = Model::parse(fmt::format("split({})", text));
    const auto& law = std::get<FixedSplit>(model.law());
    const FixedSplit of_double(law.x());
    std::vector<Size> sizes(10'000);
    std::iota(sizes.begin(), sizes.end(), Size{1});
    for (const Size last : {max_double_size, max_double_size / denominator * denominator})
      for (Size n = last - 3; n <= last; ++n) sizes.push_back(n);
    for (const Size n : sizes) {
      const auto floor = static_cast<Size>(cpp_int(n) * numerator / denominator);
      ASSERT_EQ(law.left(n), floor) << text << ", n = " << n;
      ASSERT_EQ(of_double.left(n), floor) << text << ", n = " << n;
    }
  }
}

// Denominators of 64 bits; half of n in double precision where 0.4999999999999999999 of it is less.
TEST(FixedSplitLaw, IsTheFloorOfNineteenDigits) {
  const cpp_int ten_to_19("10000000000000000000");
  int above = 0;
  for (const char* digits : {"1234567890123456789", "9876543210987654321", "4999999999999999999"}) {
    const FixedSplit law = std::get<FixedSplit>(Model::parse(fmt::format("split(0.{})", digits)).law());
    for (Size n = max_double_size - 4000; n <= max_double_size; ++n) {
      const auto floor = static_cast<Size>(cpp_int(n) * cpp_int(digits) / ten_to_19);
      const auto product = static_cast<Size>(static_cast<double>(n) * law.x());
      above += product > floor ? 1 : 0;
      ASSERT_EQ(law.left(n), floor) << digits << ", n = " << n;
    }
  }
  EXPECT_GT(above, 0);
}

TEST(FixedSplitLaw, IsOfTheNumberHoweverItIsWritten) {
  EXPECT_EQ(Model::parse("split(0.25)"), Model::parse("split(1/4)"));
  EXPECT_EQ(Model::parse("split(29e-2)").law(), AnySplitLaw(FixedSplit(0.29)));
  EXPECT_THROW(Model::parse("split(0.12345678901234567890123)"), Error);
}

// Of what a law says of itself, what can be seen in its windows.
TEST(SplitCharacter, IsSymmetricWhereTheLawIs) {
  for (const auto& text : test::all_models()) {
    const Model model = Model::parse(text);
    bool is_symmetric = true;
    for (const Size n : {2u, 3u, 4u, 7u, 100u}) {
      const auto law = pmf_of(text, n);
      for (Size i = 0; i < n; ++i) is_symmetric = is_symmetric && std::abs(law[i] - law[n - 1 - i]) < 1e-12;
    }
    EXPECT_EQ(model.character().is_symmetric, is_symmetric) << text;
  }
}

TEST(FixedSplitLaw, IsTheFloor) {
  for (const Size n : {1u, 2u, 3u, 4u, 15u, 579u, 1000u}) {
    EXPECT_EQ(pmf_of("split(0.25)", n), test::split_law(n, 0.25));
    EXPECT_EQ(pmf_of("split(0.9)", n), test::split_law(n, 0.9));
  }
  EXPECT_EQ(FixedSplit(0.999999).left(1), 0u);
}

}  // namespace
}  // namespace ramify
