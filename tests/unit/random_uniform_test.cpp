#include <cmath>
#include <cstdint>
#include <vector>

#include "support/goodness.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {
namespace {

using test::agrees;
using test::chi_square;
using test::rejected;
using test::seed_of;

/// A stream that says what it is told.
class Script {
 public:
  explicit Script(std::vector<std::uint64_t> words) : words_(std::move(words)) {}
  std::uint64_t operator()() { return words_.at(next_++); }
  std::size_t used() const { return next_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t next_ = 0;
};

TEST(UniformBelow, AgreesWithEqualProbabilities) {
  for (const std::uint64_t bound : {1u, 2u, 3u, 5u, 6u, 7u, 10u, 100u}) {
    Stream stream({seed_of("uniform below"), bound}, 0);
    std::vector<std::uint64_t> counts(bound, 0);
    for (int i = 0; i < 200000; ++i) ++counts.at(uniform_below(stream, bound));
    EXPECT_TRUE(agrees(chi_square("uniform below", counts, std::vector<double>(bound, 1.0))));
  }
}

TEST(UniformBelow, IsDistinguishedFromABoundOffByOne) {
  Stream stream({seed_of("uniform below, off by one"), 0}, 0);
  std::vector<std::uint64_t> counts(100, 0);
  for (int i = 0; i < 200000; ++i) ++counts.at(uniform_below(stream, 99));
  EXPECT_TRUE(rejected(chi_square("uniform below 99 for 100", counts, std::vector<double>(100, 1.0))));
}

// 2^64 = 1 modulo 3: of the 2^64 words exactly one is refused, the one whose product with 3 has a low half
// below 1.
TEST(UniformBelow, RefusesTheWordsThatWouldBiasIt) {
  Script biased({0, UINT64_MAX});
  EXPECT_EQ(uniform_below(biased, 3), 2u);
  EXPECT_EQ(biased.used(), 2u);
  Script fair({1});
  EXPECT_EQ(uniform_below(fair, 3), 0u);
}

TEST(UniformBelow, ReachesBothEndsOfAHugeRange) {
  const std::uint64_t bound = std::uint64_t{1} << 62;
  Script low({0}), high({UINT64_MAX});
  EXPECT_EQ(uniform_below(low, bound), 0u);
  EXPECT_EQ(uniform_below(high, bound), bound - 1);
}

TEST(UniformOpen, IsNeverZeroOrOne) {
  Script ends({0, UINT64_MAX});
  const double low = uniform_open(ends), high = uniform_open(ends);
  EXPECT_GT(low, 0);
  EXPECT_TRUE(std::isfinite(std::log(low)));
  EXPECT_LE(high, 1);
  EXPECT_TRUE(std::isfinite(std::log(1 - high))) << "1 - u is 0 at the largest word";
}

TEST(UniformOpen, AgreesWithTheUniformLaw) {
  Stream stream({seed_of("uniform open"), 0}, 0);
  std::vector<std::uint64_t> counts(64, 0);
  for (int i = 0; i < 500000; ++i) ++counts.at(static_cast<std::size_t>(64 * uniform_open(stream)));
  EXPECT_TRUE(agrees(chi_square("uniform open", counts, std::vector<double>(64, 1.0))));
}

}  // namespace
}  // namespace ramify
