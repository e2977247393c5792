#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {
namespace {

using Names = std::vector<std::string>;

TEST(Error, SaysProblemWhyAndRemedyInOneLine) {
  const Error error("p = 2", "p must lie in (0,1)", "give a probability");
  EXPECT_STREQ(error.what(), "p = 2 (p must lie in (0,1)): give a probability");
}

TEST(SourceLocation, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(to_prefix({"a.toml", 3, 7}), "a.toml:3:7: ");
  EXPECT_EQ(to_prefix({"a.toml", 3, 0}), "a.toml:3: ");
  EXPECT_EQ(to_prefix({"a.toml", 0, 0}), "a.toml: ");
  EXPECT_EQ(to_prefix({}), "");
}

TEST(NearestNames, FindsTheMistypedName) {
  const Names known{"bst", "beta", "split", "dst", "patricia", "catalan"};
  EXPECT_EQ(nearest_names("patrica", known), Names{"patricia"});
  EXPECT_EQ(nearest_names("ctaalan", known), Names{"catalan"});  // a swap counts once
  EXPECT_EQ(nearest_names("bts", known).front(), "bst");
  EXPECT_EQ(nearest_names("bst", known).front(), "bst");
  EXPECT_TRUE(nearest_names("quadtree", known).empty());
}

TEST(NearestNames, GivesThreeAtMostClosestFirst) {
  const Names known{"aaaa", "aaab", "aabb", "aaac", "aaaaa"};
  const auto nearest = nearest_names("aaaa", known);
  ASSERT_EQ(nearest.size(), 3u);
  EXPECT_EQ(nearest.front(), "aaaa");
}

TEST(DidYouMean, IsEmptyWhereNothingIsNear) {
  EXPECT_EQ(did_you_mean("dts", {"dst", "catalan"}), "did you mean dst? ");
  EXPECT_EQ(did_you_mean("zzzzzz", {"dst", "catalan"}), "");
}

TEST(Cancellation, IsRequestedOnceAndForAll) {
  Cancellation cancellation;
  EXPECT_FALSE(cancellation.requested());
  cancellation.request();
  EXPECT_TRUE(cancellation.requested());
}

#if defined(RAMIFY_CONTRACTS)
TEST(ContractDeathTest, EndsTheProgramAndSaysWhere) {
  EXPECT_DEATH(RAMIFY_EXPECTS(1 + 1 == 3), "core_error_test.cpp:[0-9]+: contract broken: 1 \\+ 1 == 3");
}

TEST(ContractDeathTest, GuardsPreconditions) {
  Stream stream({1, 2}, 3);
  EXPECT_DEATH(uniform_below(stream, 0), "contract broken: bound >= 1");
  EXPECT_DEATH(Tree({2, 0}), "contract broken: is_well_formed");
}
#endif

TEST(Contract, HoldsQuietlyAndIsEvaluatedAtMostOnce) {
  int evaluated = 0;
  RAMIFY_EXPECTS(++evaluated == 1);
#if defined(RAMIFY_CONTRACTS)
  EXPECT_EQ(evaluated, 1);
#else
  EXPECT_EQ(evaluated, 0);
#endif
}

}  // namespace
}  // namespace ramify
