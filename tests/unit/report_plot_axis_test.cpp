#include <gtest/gtest.h>

#include "ramify/report/plot_axis.hpp"

namespace ramify::detail {
namespace {

PlotAxis axis(bool logarithmic, double low, double high) {
  PlotAxis result(logarithmic);
  result.include(high);
  result.include(low);
  return result;
}

TEST(PlotAxis, PadsOnItsOwnScale) {
  PlotAxis linear = axis(false, 10, 20);
  linear.pad(0.1);
  EXPECT_DOUBLE_EQ(linear.low(), 9);
  EXPECT_DOUBLE_EQ(linear.high(), 21);
  PlotAxis log = axis(true, 10, 1000);
  log.pad(0.5);
  EXPECT_DOUBLE_EQ(log.low(), 1);
  EXPECT_DOUBLE_EQ(log.high(), 10'000);
  PlotAxis point = axis(false, 0, 0);
  point.pad(0.1);
  EXPECT_LT(point.low(), point.high());
}

TEST(PlotAxis, DecadesBecomeSuperscriptsWhereTheyAreLong) {
  EXPECT_EQ(decade_label(2, true), "100");
  EXPECT_EQ(decade_label(-3, true), "0.001");
  EXPECT_EQ(decade_label(12, false), "10¹²");
  EXPECT_EQ(decade_label(-10, false), "10⁻¹⁰");
  EXPECT_NE(axis(true, 1, 20'000).script("x").find("'10000' 1e4, '' 2e4 1)"), std::string::npos);
  EXPECT_NE(axis(true, 1, 200'000).script("x").find("'10⁵' 1e5, '' 2e5 1)"), std::string::npos);
}

TEST(PlotAxis, ShortLogAxesHaveLabelsBetweenTheDecades) {
  EXPECT_NE(axis(true, 9, 110).script("x").find("'10' 1e1, '20' 2e1, '' 3e1 1, '' 4e1 1, '50' 5e1,"),
            std::string::npos);
  EXPECT_NE(axis(true, 1.5e6, 2.5e7).script("x").find("'2·10⁶' 2e6"), std::string::npos);
  EXPECT_NE(axis(true, 4.1, 4.9).script("y").find("set ytics ('4.2' 4.2, '4.4' 4.4, '4.6' 4.6, '4.8' 4.8)"),
            std::string::npos);
}

TEST(PlotAxis, LogAxisHoldsPositiveNumbersOnly) {
  EXPECT_FALSE(PlotAxis(true).holds(0));
  EXPECT_TRUE(PlotAxis(true).holds(1e-300));
  EXPECT_TRUE(PlotAxis(false).holds(-1));
}

}  // namespace
}  // namespace ramify::detail
