// Accumulators are values: written, read and merged without the loss of a bit.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ramify/accumulate/accumulator_json.hpp"
#include "ramify/core/error.hpp"

namespace ramify {
namespace {

using nlohmann::json;

constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min(),
                       highest = std::numeric_limits<std::int64_t>::max();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Through CBOR, and through text.
template <class Accumulator>
void expect_survives(const Accumulator& accumulator) {
  const json value = accumulator;
  EXPECT_EQ(json::from_cbor(json::to_cbor(value)).get<Accumulator>(), accumulator);
  EXPECT_EQ(json::parse(value.dump()).get<Accumulator>(), accumulator);
}

WholeSummary awkward_wholes() {
  WholeSummary summary;
  for (const std::int64_t value : {lowest, std::int64_t{-1}, std::int64_t{0}, std::int64_t{0}, highest})
    summary.add(value);
  summary.add(3, std::uint64_t{1} << 63);
  return summary;
}

RealSummary awkward_reals() {
  RealSummary summary;
  for (const double value : {0.1, -0.0, 0x1p63, 1e300, -1e300, std::numeric_limits<double>::denorm_min(),
                             1.0 / 3, infinity, -infinity, std::nan("")})
    summary.add(value);
  return summary;
}

/// Squares fill 128 bits but for the sign.
OrderTotals awkward_totals() {
  OrderTotals totals;
  HortonStrahler::Counts counts{};
  counts[0] = std::numeric_limits<std::uint64_t>::max() / 2;
  counts[1] = std::uint64_t{1} << 62;
  counts[2] = 1;
  totals.add(counts, 2);
  counts[1] = 5;
  totals.add(counts, 1);
  return totals;
}

TEST(AccumulatorJson, EveryBitSurvives) {
  expect_survives(awkward_wholes());
  expect_survives(awkward_reals());
  expect_survives(awkward_totals());
}

TEST(AccumulatorJson, SoDoesNothing) {
  expect_survives(WholeSummary());
  expect_survives(RealSummary());
  expect_survives(OrderTotals());
}

TEST(AccumulatorJson, KeepsTheSignOfZeroAndTheOrderOfReals) {
  const json value = awkward_reals();
  const auto arrived = json::parse(value.dump()).get<RealSummary>();
  const auto& values = arrived.values();
  ASSERT_EQ(values.size(), 9u);  // a NaN is no value
  EXPECT_TRUE(std::signbit(values[1]));
  EXPECT_EQ(values[7], infinity);
  EXPECT_EQ(values[8], -infinity);
}

/// merge(a, b) after a round trip is merge(a, b), and no other.
template <class Accumulator>
void expect_merges(const Accumulator& a, const Accumulator& b) {
  Accumulator direct = a, travelled = json(a).template get<Accumulator>();
  direct.merge(b);
  travelled.merge(json::from_cbor(json::to_cbor(json(b))).template get<Accumulator>());
  EXPECT_EQ(direct, travelled);
  EXPECT_NE(direct, a);
}

TEST(AccumulatorJson, MergesAsIfItHadNotTravelled) {
  expect_merges(awkward_wholes(), awkward_wholes());
  expect_merges(awkward_reals(), awkward_reals());
  expect_merges(awkward_totals(), awkward_totals());
}

TEST(AccumulatorJson, RefusesWhatIsNoAccumulator) {
  EXPECT_THROW(json({{"x", 1}}).get<WholeSummary>(), json::exception);
  EXPECT_THROW(json({{1}}).get<WholeSummary>(), json::exception);
  EXPECT_THROW(json::array({nullptr}).get<RealSummary>(), json::exception);
  EXPECT_THROW(json({{"trees", 1}}).get<OrderTotals>(), json::exception);
  EXPECT_THROW(json({{"trees", 1}, {"orders", json::array()}}).get<OrderTotals>(), Error);
  EXPECT_THROW(json({{"trees", 1}, {"orders", {{"1", "x", "1"}}}}).get<OrderTotals>(), Error);
  const json order{"1", "1", "0"};
  EXPECT_THROW(json({{"trees", 1}, {"orders", std::vector<json>(100, order)}}).get<OrderTotals>(), Error);
}

}  // namespace
}  // namespace ramify
