// The one rule, on made-up intervals: what it must reproduce, refute and leave open.
#include <cmath>

#include <gtest/gtest.h>

#include "ramify/compare/judge.hpp"

namespace ramify {
namespace {

Statement statement(Relation relation, double theory, std::vector<NamedValue> rivals = {}) {
  return {"C0.1", "x", "nobody", "none", relation, "x", theory, std::move(rivals), std::nullopt};
}

TEST(Judge, ReproducesWhatContainsTheTheoryAndExcludesTheRivals) {
  const Statement two = statement(Relation::equals, 2, {{"a rival", 2.1}, {"another", 1}});
  EXPECT_EQ(judge(two, {1.95, 2.05}), Decision::reproduced);
  EXPECT_EQ(judge(two, {2, 2}), Decision::reproduced);
  EXPECT_EQ(judge(two, {1.9, 2.1}), Decision::inconclusive) << "the rival is possible too";
  EXPECT_EQ(judge(two, {-HUGE_VAL, HUGE_VAL}), Decision::inconclusive);
}

TEST(Judge, RefutesWhatExcludesTheTheoryHoweverNearItIs) {
  EXPECT_EQ(judge(statement(Relation::equals, 2), {2.0000001, 2.0000002}), Decision::refuted);
  EXPECT_EQ(judge(statement(Relation::equals, 2), {1.9, 1.9999999}), Decision::refuted);
}

TEST(Judge, OfABoundTheWholeIntervalDecides) {
  EXPECT_EQ(judge(statement(Relation::at_most, 2), {1, 2}), Decision::reproduced);
  EXPECT_EQ(judge(statement(Relation::at_most, 2), {1.9, 2.1}), Decision::inconclusive);
  EXPECT_EQ(judge(statement(Relation::at_most, 2), {2.1, 3}), Decision::refuted);
  EXPECT_EQ(judge(statement(Relation::at_least, 2), {2, 3}), Decision::reproduced);
  EXPECT_EQ(judge(statement(Relation::at_least, 2), {1, 1.9}), Decision::refuted);
}

TEST(Judge, NeverReproducesARivalOfWhatItReproduces) {
  const Statement two = statement(Relation::equals, 2, {{"a rival", 2.1}, {"another", 1}});
  for (std::size_t i = 0; i < two.rivals.size(); ++i) {
    EXPECT_EQ(with_rival(two, i).rivals[i].value, 2);
    EXPECT_EQ(judge(with_rival(two, i), {1.95, 2.05}), Decision::refuted);
  }
}

TEST(Interval, SimultaneousOnesAreWider) {
  EXPECT_NEAR(simultaneous_sigmas(0.01, 1), 2.5758293035489, 1e-12);
  EXPECT_NEAR(simultaneous_sigmas(0.01, 0), 2.5758293035489, 1e-12);
  EXPECT_NEAR(simultaneous_sigmas(0.05, 5), 2.5758293035489, 1e-12);
  EXPECT_NEAR(simultaneous_sigmas(1e-6, 1000), 6.10941, 1e-5) << "two-sided 1e-9";
}

TEST(SamplerCheck, FailsBeyondWhatAllMeansTogetherAllow) {
  EXPECT_EQ((SamplerCheck{0, 0, 5}).word(), "not sampled");
  EXPECT_EQ((SamplerCheck{0, 0, 5, false}).word(), "-");
  EXPECT_EQ((SamplerCheck{3, 4.9, 5}).word(), "ok");
  EXPECT_EQ((SamplerCheck{3, 5.1, 5}).word(), "failed");
}

}  // namespace
}  // namespace ramify
