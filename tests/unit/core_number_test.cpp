#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "ramify/core/number.hpp"
#include "ramify/core/wide.hpp"

namespace ramify {
namespace {

TEST(ParseReal, ReadsDecimalsAndFractions) {
  EXPECT_EQ(parse_real("0.23"), 0.23);
  EXPECT_EQ(parse_real("1/4.35"), 1 / 4.35);
  EXPECT_EQ(parse_real("1/4"), 0.25);
  EXPECT_EQ(parse_real("1e-3"), 0.001);
  EXPECT_EQ(parse_real("+2.5"), 2.5);
  EXPECT_EQ(parse_real("-3"), -3.0);
  EXPECT_EQ(parse_real("10"), 10.0);
}

TEST(ParseReal, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "x", "0.2x", "1/0", "1/", "/2", "1/2/3", "nan", "inf", "-inf", "1e999", "0,5",
                           " 1", "1 ", "0x10"})
    EXPECT_FALSE(parse_real(text)) << text;
}

TEST(ParseReal, NeverGivesAnInfinity) {
  EXPECT_FALSE(parse_real("1e308/1e-308"));
  EXPECT_FALSE(parse_real("+-1"));
}

TEST(ParseCount, ReadsDigitsUnderscoresAndPowers) {
  EXPECT_EQ(parse_count("0"), 0u);
  EXPECT_EQ(parse_count("1000"), 1000u);
  EXPECT_EQ(parse_count("1_000_000"), 1000000u);
  EXPECT_EQ(parse_count("1e6"), 1000000u);
  EXPECT_EQ(parse_count("1E6"), 1000000u);
  EXPECT_EQ(parse_count("25e0"), 25u);
  EXPECT_EQ(parse_count("10^6"), 1000000u);
  EXPECT_EQ(parse_count("2^62"), std::uint64_t{1} << 62);
  EXPECT_EQ(parse_count("2^63"), std::uint64_t{1} << 63);
  EXPECT_EQ(parse_count("18446744073709551615"), UINT64_MAX);
}

TEST(ParseCount, RefusesNegativesFractionsAndOverflow) {
  for (const char* text : {"",      "-1",    "-0",  "+1",    "1.5",  "1.0",
                           "1e-3",  "1e",    "e6",  "1e1.5", "2^64", "18446744073709551616",
                           "1e20",  "10^20", "2^",  "^2",    "_",    "x",
                           "1 000", " 1",    "1 ",  "1,000", "inf",  "nan",
                           "1e6e6", "2^3^2", "0x10"})
    EXPECT_FALSE(parse_count(text)) << text;
}

TEST(FormatExact, ReadsBackAsTheSameDouble) {
  for (const double value : {0.1, 1 / 4.35, 1e300, 5e-324, 0.0, -2.5, 3.0, 1.0 / 3})
    EXPECT_EQ(std::strtod(format_exact(value).c_str(), nullptr), value) << format_exact(value);
  EXPECT_EQ(format_exact(0.1), "0.1");
}

TEST(FormatSummary, KeepsTenDigitsAndNoMinusZero) {
  EXPECT_EQ(format_summary(1.0 / 3), "0.3333333333");
  EXPECT_EQ(format_summary(-0.0), "0");
  EXPECT_EQ(format_summary(6.0), "6");
  EXPECT_EQ(format_summary(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(MultiplyWide, GivesBothHalves) {
  const std::uint64_t all = UINT64_MAX;
  EXPECT_EQ(multiply_wide(all, all).high, all - 1);
  EXPECT_EQ(multiply_wide(all, all).low, 1u);
  EXPECT_EQ(multiply_wide(std::uint64_t{1} << 63, 6).high, 3u);
  EXPECT_EQ(multiply_wide(std::uint64_t{1} << 63, 6).low, 0u);
  EXPECT_EQ(multiply_wide(0x123456789abcdef0u, 0xfedcba9876543210u).high, 0x121fa00ad77d7422u);
  EXPECT_EQ(multiply_wide(0x123456789abcdef0u, 0xfedcba9876543210u).low, 0x236d88fe5618cf00u);
}

TEST(WideProduct, IsSubtractedModulo2To128) {
  const WideProduct two_to_64{1, 0}, one{0, 1};
  EXPECT_EQ((two_to_64 - one).high, 0u);
  EXPECT_EQ((two_to_64 - one).low, UINT64_MAX);
  EXPECT_EQ((one - two_to_64).high, UINT64_MAX);
  EXPECT_EQ((one - two_to_64).low, 1u);
}

}  // namespace
}  // namespace ramify
