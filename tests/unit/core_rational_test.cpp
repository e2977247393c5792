#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "ramify/core/number.hpp"
#include "ramify/core/rational.hpp"

namespace ramify {
namespace {

TEST(Rational, IsWhatIsWritten) {
  const auto is = [](const char* text, std::uint64_t numerator, std::uint64_t denominator) {
    EXPECT_EQ(Rational::parse(text), (Rational{numerator, denominator})) << text;
  };
  is("0.29", 29, 100);
  is("+.5", 1, 2);
  is("25e-2", 1, 4);
  is("1/4.35", 20, 87);
  is("1/49", 1, 49);
  is("0.1/0.3", 1, 3);
  is("1e-3/2E+1", 1, 20000);
  is("12345678901234567890", 12345678901234567890u, 1);
  is("1e-19", 1, 10'000'000'000'000'000'000u);
  is("0", 0, 1);
}

TEST(Rational, IsNothingWhereItIsNoNumberOrDoesNotFit) {
  for (const char* text : {"", ".", "x", "0.2x", "-0.1", "1/0", "1/", "1e", "1e5000", "0x1", "inf", "1.2.3"})
    EXPECT_FALSE(Rational::parse(text)) << text;
  for (const char* text : {"0.12345678901234567890123", "1e-20", "1e20", "1/1e-20"})
    EXPECT_FALSE(Rational::parse(text)) << text;
}

// A decimal or a quotient of small numbers that has become a double comes back.
TEST(Rational, OfADoubleIsTheFractionThatItStandsFor) {
  for (std::uint64_t q = 2; q <= 1000; ++q)
    for (std::uint64_t p = 0; p < q; ++p) {
      const Rational of = Rational::of(static_cast<double>(p) / static_cast<double>(q));
      ASSERT_EQ(of.numerator * q, p * of.denominator) << p << '/' << q;
    }
  for (const char* text : {"0.29", "0.3", "0.57", "0.123456", "0.9999999", "3/7919"})
    EXPECT_EQ(Rational::of(*parse_real(text)), Rational::parse(text)) << text;
}

TEST(Rational, OfAnyDoubleIsAsNearAsItsDigits) {
  for (const double x : {std::sqrt(0.5), 1 - 0x1p-53, 0x1p-53, std::exp(-20.0), 1 / std::exp(1.0)}) {
    const Rational of = Rational::of(x);
    EXPECT_EQ(static_cast<double>(of.numerator) / static_cast<double>(of.denominator), x);
    EXPECT_LT(of.numerator, of.denominator);
  }
  EXPECT_EQ(Rational::of(1e-300).numerator, 0u);
}

}  // namespace
}  // namespace ramify
