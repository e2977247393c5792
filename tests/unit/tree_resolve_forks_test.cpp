#include <cmath>
#include <map>

#include "support/error_of.hpp"
#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/tree/parenthesis_word.hpp"
#include "ramify/tree/resolve_forks.hpp"

namespace ramify {
namespace {

RecordedTree resolved(std::string_view newick, ForkResolution resolution, std::uint64_t replicate = 0) {
  Stream stream({1996, 0}, replicate);
  return resolve_forks(test::tree_of(newick), resolution, stream);
}

TEST(ResolveForks, LadderTakesTheFirstChildAgainAndAgain) {
  const RecordedTree tree = resolved("(a:1,b:2,(c:1,d:1,e:1):3,f:4)r:5;", ForkResolution::ladder);
  EXPECT_EQ(write_trees({tree}, TreeFormat::newick), "(a:1,(b:2,((c:1,(d:1,e:1):0):3,f:4):0):0)r:5;\n");
  EXPECT_EQ(wide_forks(tree.tree), 0u);
}

TEST(ResolveForks, LeavesOtherForksAlone) {
  for (const char* word : {"E", "(EE)", "((E)(E(EE)))"}) {
    RecordedTree tree;
    tree.tree = from_parentheses(word);
    Stream stream({1996, 0}, 0);
    EXPECT_EQ(to_parentheses(resolve_forks(tree, ForkResolution::random, stream).tree), word);
  }
}

/// Of three children each is as often the one that is joined last; of four a balanced tree comes in 1 of 3.
TEST(ResolveForks, RandomJoinsAreThoseOfAYuleTree) {
  std::map<std::string, int> alone;
  int balanced = 0;
  constexpr int trees = 3000;
  for (int i = 0; i < trees; ++i) {
    const auto replicate = static_cast<std::uint64_t>(i);
    const std::string three =
        write_trees({resolved("(a,b,c);", ForkResolution::random, replicate)}, TreeFormat::newick);
    for (const char* name : {"a", "b", "c"}) {
      const auto place = three.find(name);
      const bool in_pair =
          three.substr(0, place).find("((") == 0 ? place < three.find(')') : place > three.rfind('(');
      if (!in_pair) ++alone[name];
    }
    balanced +=
        to_parentheses(resolved("(a,b,c,d);", ForkResolution::random, replicate).tree) == "((EE)(EE))";
  }
  const double bound = 5 * std::sqrt(trees * 2.0 / 9);  // 5 standard deviations of a count with p = 1/3
  for (const char* name : {"a", "b", "c"}) EXPECT_NEAR(alone[name], trees / 3.0, bound) << name;
  EXPECT_NEAR(balanced, trees / 3.0, bound);
}

TEST(ResolveForks, CountsWideForks) {
  EXPECT_EQ(wide_forks(from_parentheses("((EEE)(EE)(E(EEEE)))")), 3u);
  EXPECT_EQ(wide_forks(from_parentheses("(E(E))")), 0u);
  EXPECT_NE(test::error_of([] { parse_fork_resolution("comb"); }).find("take ladder or random"),
            std::string::npos);
}

}  // namespace
}  // namespace ramify
