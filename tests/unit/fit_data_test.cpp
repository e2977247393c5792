// Reading measured ratios and counts, and what is refused.
#include <cmath>
#include <string>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/fit/ratio_datum.hpp"

namespace ramify {
namespace {

std::string data_refusal(std::string_view text) {
  return test::error_of([&] { parse_ratio_data(text, "x.csv"); });
}

void expect_refused(std::string_view text, std::string_view place, std::string_view word) {
  const std::string message = data_refusal(text);
  EXPECT_TRUE(message.starts_with(place)) << "'" << message << "' for\n" << text;
  EXPECT_NE(message.find(word), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

double observed(const RatioDatum& datum, RatioEstimator estimator) {
  return *datum.observed[index_of(estimator)];
}

TEST(FitData, SpeciesTable) {
  const auto data = read_ratio_data(RAMIFY_SOURCE_DIR "/data/species.csv");
  ASSERT_EQ(data.size(), 5u);
  EXPECT_EQ(data[0].name, "apple");
  EXPECT_EQ(data[0].ratio, 4.35);
  ASSERT_EQ(data[0].sizes.size(), 1u);
  EXPECT_EQ(data[0].sizes[0].n, 579u);
  EXPECT_EQ(data[0].sizes[0].source, "printed");
  EXPECT_EQ(observed(data[0], RatioEstimator::nodes_geometric), 4.35);
  EXPECT_EQ(data[1].name, "white oak");
  EXPECT_EQ(data[1].ratio, 4.11);
  EXPECT_TRUE(data[1].sizes.empty());
  EXPECT_EQ(data[2].sizes.at(0).n, 670u);
  EXPECT_EQ(data[2].sizes.at(0).source, "horton");
  EXPECT_EQ(data[2].sizes.size(), 1u);
  // Ranges of orders: both ends, 4-7 and 3-5.
  ASSERT_EQ(data[3].sizes.size(), 2u);
  EXPECT_EQ(data[3].sizes[0].n, 47u);
  EXPECT_EQ(data[3].sizes[1].n, 1534u);
  ASSERT_EQ(data[4].sizes.size(), 2u);
  EXPECT_EQ(data[4].sizes[0].n, 58u);
  EXPECT_EQ(data[4].sizes[1].n, 2878u);
  for (const RatioDatum& datum : data) EXPECT_FALSE(datum.citation.empty() || datum.confidence.empty());
}

TEST(FitData, LungTable) {
  const auto data = read_ratio_data(RAMIFY_SOURCE_DIR "/data/lung.csv");
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0].ratio, 3.39);
  EXPECT_EQ(data[0].diameter_ratio->value, 1.71);
  EXPECT_EQ(data[1].ratio, 2.74);
  EXPECT_EQ(data[1].diameter_ratio->value, 1.40);
  EXPECT_DOUBLE_EQ(data[1].diameter_ratio->rounding, 0.005);
  for (const RatioDatum& datum : data) {  // the part that the thesis draws, and the whole: 17 orders
    ASSERT_EQ(datum.sizes.size(), 2u);
    EXPECT_EQ(datum.sizes[0].n, 1000u);
    EXPECT_EQ(datum.sizes[0].source, "portion");
    EXPECT_EQ(datum.sizes[1].source, "horton");
  }
  EXPECT_EQ(data[0].sizes[1].n, 431'516'064u);
  EXPECT_EQ(data[1].sizes[1].n, 15'893'162u);
}

TEST(FitData, HortonSize) {
  // The complete binary tree: 1 + 2 + 4 + 8; the apple: 464.7.
  EXPECT_EQ(whole_horton_size(2, 4), 15u);
  EXPECT_EQ(whole_horton_size(4.35, 5), 465u);
  EXPECT_EQ(whole_horton_size(1000, 60), max_size);
}

TEST(FitData, CountTable) {
  const auto data = parse_ratio_data(
      "order,count,diameter\n1,1868,1\n2,596,2\n3,182,4\n4,50,8\n5,16,\n6,6,\n7,1,64\n", "there/walnut.csv");
  ASSERT_EQ(data.size(), 1u);
  const RatioDatum& walnut = data[0];
  EXPECT_EQ(walnut.name, "walnut");
  // Streams of one walnut: mean ratio 3.64 (its nodes would give 2.44).
  const double mean = (1868. / 596 + 596. / 182 + 182. / 50 + 50. / 16 + 16. / 6 + 6. / 1) / 6;
  EXPECT_DOUBLE_EQ(observed(walnut, RatioEstimator::streams_mean_ratio), mean);
  EXPECT_DOUBLE_EQ(observed(walnut, RatioEstimator::streams_geometric), std::pow(1868., 1. / 6));
  EXPECT_FALSE(walnut.observed[index_of(RatioEstimator::nodes_mean_ratio)]);
  EXPECT_EQ(walnut.sizes.at(0).n, 1867u);
  EXPECT_EQ(walnut.sizes.at(0).source, "counted");
  EXPECT_NEAR(walnut.diameter_ratio->value, 2, 1e-12);
  EXPECT_TRUE(walnut.warnings.empty());
}

TEST(FitData, LeafOrderMayBeZero) {
  EXPECT_EQ(parse_ratio_data("order,count,leaf_order\n0,10,0\n1,4,0\n2,1,0\n", "x.csv")[0].sizes[0].n, 9u);
  expect_refused("order,count\n0,10\n1,4\n", "x.csv:2:1:", "order 1 comes here");
  expect_refused("order,count,leaf_order\n0,10,0\n1,4,1\n", "x.csv:3:5:", "leaf_order 1");
}

TEST(FitData, WarnsOfCountsThatAreNotStreams) {
  // A published river table: sum 1453 against 2*726-1 = 1451.
  const auto data = parse_ratio_data("order,count\n1,726\n2,356\n3,171\n4,144\n5,45\n6,11\n", "river.csv");
  ASSERT_EQ(data[0].warnings.size(), 3u);
  EXPECT_NE(data[0].warnings[0].find("links"), std::string::npos);
  EXPECT_NE(data[0].warnings[1].find("144 after 171"), std::string::npos);
  EXPECT_NE(data[0].warnings[2].find("highest order"), std::string::npos);
}

TEST(FitData, RefusesRatiosThatNoTreeHas) {
  expect_refused("name,ratio\na,3\nb,2\n", "x.csv:3:3:", "ratio 2");
  expect_refused("# note\nname,ratio\na,1.5\n", "x.csv:3:3:", "above 2");
  expect_refused("name,ratio\na,nan\n", "x.csv:2:3:", "nan");
  expect_refused("name,ratio\na,inf\n", "x.csv:2:3:", "inf");
  expect_refused("name,ratio\na,\n", "x.csv:2:3:", "ratio");
  expect_refused("name,ratio,diameter_ratio\na,3,0.9\n", "x.csv:2:5:", "diameter_ratio");
  expect_refused("order,count\n1,10\n2,6\n3,5\n", "x.csv:", "above 2");
}

TEST(FitData, RefusesOrdersAndCountsThatMakeNoSense) {
  expect_refused("name,ratio,max_order_low\na,3,1\n", "x.csv:2:5:", "max_order_low 1");
  expect_refused("name,ratio,max_order_low,max_order_high\na,3,5,4\n", "x.csv:2:7:", "below max_order_low");
  expect_refused("name,ratio,branches\na,3,1\n", "x.csv:2:5:", "branches 1");
  expect_refused("order,count\n1,10\n2,10\n", "x.csv:3:3:", "fewer");
  expect_refused("order,count\n1,10\n2,0\n", "x.csv:3:3:", "count 0");
  expect_refused("order,count\n1,10\n3,2\n", "x.csv:3:1:", "order 2 comes here");
  expect_refused("order,count\n1,10\n2,3.5\n", "x.csv:3:3:", "3.5");
  expect_refused("order,count\n1,10\n", "x.csv", "two orders");
}

TEST(FitData, RefusesUnknownColumnsAndSecondNames) {
  expect_refused("name,ratoi\na,3\n", "x.csv", "did you mean ratio");
  expect_refused("order,cuont\n1,10\n", "x.csv:1:1:", "no column of counts");
  expect_refused("name,ratio\na,3\na,4\n", "x.csv:3", "line 2");
  expect_refused("name,ratio\n", "x.csv", "no rows");
}

}  // namespace
}  // namespace ramify
