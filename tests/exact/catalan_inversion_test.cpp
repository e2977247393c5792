#include <vector>

#include "support/seed.hpp"
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "ramify/model/catalan.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

/// C_0 .. C_n.
std::vector<Real> catalan_numbers(Size n) {
  std::vector<Real> numbers{1};
  for (Size i = 0; i < n; ++i) numbers.push_back(numbers.back() * Real(2 * (2 * i + 1)) / Real(i + 2));
  return numbers;
}

TEST(CentralBinomial, IsTheProduct) {
  Real g = 1;
  for (Size i = 0; i <= 200000; ++i) {
    if (i < 300 || i % 997 == 0) {
      ASSERT_NEAR(static_cast<double>(Real(Catalan::central_binomial(i)) / g - 1), 0, 1e-15) << i;
    }
    g *= Real(2 * i + 1) / Real(2 * i + 2);
  }
}

// P(left < k) by adding up C_i C_(n-1-i) / C_n; the level of k is 1 - 2 P(left < k), and just on either side
// of it the inversion must change from k to k-1.
TEST(CatalanInversion, StepsWhereTheSumsSay) {
  const auto catalan = catalan_numbers(200);
  for (Size n = 2; n <= 200; ++n) {
    const Size last = (n - 1) / 2;
    Real below = 0;
    for (Size k = 0; k <= last; ++k) {
      const double level = static_cast<double>(1 - 2 * below);
      if (k > 0) {
        ASSERT_EQ(Catalan::smaller_half(n, level * (1 + 1e-12)), k - 1) << "n = " << n << ", k = " << k;
      }
      ASSERT_EQ(Catalan::smaller_half(n, level * (1 - 1e-12)), k) << "n = " << n << ", k = " << k;
      below += catalan[k] * catalan[n - 1 - k] / catalan[n];
    }
    ASSERT_EQ(Catalan::smaller_half(n, 1e-300), last);
  }
}

// A scan of the levels, each against a search through the sums.
TEST(CatalanInversion, AgreesWithASearchOnAFineScan) {
  const auto catalan = catalan_numbers(200);
  for (const Size n : {2u, 3u, 10u, 11u, 64u, 65u, 199u, 200u}) {
    Size k = (n - 1) / 2;
    std::vector<double> levels{1};
    Real below = 0;
    for (Size i = 0; i <= k; ++i)
      levels.push_back(static_cast<double>(1 - 2 * (below += catalan[i] * catalan[n - 1 - i] / catalan[n])));
    for (int step = 1; step < 10000; ++step) {
      const double u = (step + 0.314159) / 10001;
      while (k > 0 && levels[k] < u) --k;
      ASSERT_EQ(Catalan::smaller_half(n, u), k) << "n = " << n << ", u = " << u;
    }
  }
}

// At the largest size; a search that starts far from its place would not end.
TEST(CatalanInversion, StaysInRangeAtTheLargestSize) {
  const Size n = Catalan::largest_size();
  Stream stream({test::seed_of("catalan, largest"), 0}, 0);
  for (int i = 0; i < 20000; ++i) ASSERT_LT(Catalan().left(n, stream), n);
}

}  // namespace
}  // namespace ramify
