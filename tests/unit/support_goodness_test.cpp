// The power of negative controls, against what 5,000 samples of a wrong law do.
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {
namespace {

using test::chi_square;
using test::Goodness;
using test::least_power;

constexpr std::array<double, 6> claimed{0.3, 0.25, 0.2, 0.12, 0.08, 0.05};

/// A law beside the claimed one, the farther the larger the shift.
std::vector<double> shifted(double shift) {
  std::vector<double> law(claimed.begin(), claimed.end());
  law.front() -= shift;
  law.back() += shift;
  return law;
}

struct Rejections {
  double share = 0;           ///< of the samples, that are rejected
  double known = 0;           ///< power by both laws
  double largest_least = 0;   ///< of the powers that one sample leaves
  double least_too_high = 0;  ///< how often that is more than the power
};

Rejections rejections_of(double shift) {
  constexpr int samples = 5000, draws = 2000, looked_at = 10;
  const std::vector<double> truth = shifted(shift);
  std::vector<double> rising(truth.size());
  std::partial_sum(truth.begin(), truth.end(), rising.begin());
  Stream stream({test::seed_of("power of chi-square"), 0}, static_cast<std::uint64_t>(1e4 * shift));
  Rejections found;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<std::uint64_t> counts(truth.size(), 0);
    for (int draw = 0; draw < draws; ++draw) {
      const double u = uniform_open(stream);
      std::size_t cell = 0;
      while (cell + 1 < rising.size() && u > rising[cell]) ++cell;
      ++counts[cell];
    }
    Goodness goodness = chi_square("power", counts, claimed, 5, truth);
    found.share += (goodness.p_value < test::alpha ? 1.0 : 0.0) / samples;
    if (sample % looked_at != 0) continue;
    found.known = least_power(goodness);
    goodness = chi_square("power", counts, claimed);
    const double least = least_power(goodness);
    found.largest_least = std::fmax(found.largest_least, least);
    found.least_too_high += (least > found.known ? 1.0 : 0.0) * looked_at / samples;
  }
  return found;
}

TEST(LeastPower, IsThatOf5000Samples) {
  if (test::sanitized) GTEST_SKIP() << "a law is for the release build to hold";
  for (const double shift : {0.02, 0.025, 0.03, 0.04}) {
    const Rejections found = rejections_of(shift);
    const double error = 4 * std::sqrt(found.known * (1 - found.known) / 5000);
    EXPECT_NEAR(found.share, found.known, error + 0.02) << shift;
    EXPECT_LE(found.least_too_high, 0.01) << shift;
  }
}

TEST(LeastPower, TellsWeakControlsFromStrongOnes) {
  if (test::sanitized) GTEST_SKIP() << "a law is for the release build to hold";
  const Rejections weak = rejections_of(0.02), strong = rejections_of(0.08);
  EXPECT_LT(weak.known, 0.5);
  EXPECT_LT(weak.share, 0.5);
  EXPECT_GT(strong.known, 0.999999);
  EXPECT_GT(strong.largest_least, test::needed_power);
}

TEST(LeastPower, OfMeansAndOfImpossibleDraws) {
  const auto of_z = [](double z) { return least_power({"z", z, 0, std::erfc(z / std::sqrt(2.0))}); };
  EXPECT_NEAR(of_z(4.8916 + 3.0902), 0.5, 1e-3);            // seen just as far beyond as is in doubt
  EXPECT_NEAR(of_z(4.8916 + 2 * 3.0902), 0.999, 1e-5);      // and once more
  EXPECT_EQ(of_z(60), 1);                                   // p is 0 in double precision
  EXPECT_LT(least_power({"impossible", 5, 0, 0, 5}), 0.9);  // might have been none
  EXPECT_GT(least_power({"impossible", 40, 0, 0, 40}), test::needed_power);
}

TEST(Rejected, WantsPowerAsWell) {
  if (test::sanitized) GTEST_SKIP() << "decides nothing there";
  EXPECT_TRUE(test::rejected({"strong", 12, 0, 1e-30}));
  EXPECT_FALSE(test::rejected({"by luck", 5, 0, 1e-7})) << "alpha is 1e-6";
  EXPECT_FALSE(test::rejected({"passed", 1, 0, 0.3}));
}

}  // namespace
}  // namespace ramify
