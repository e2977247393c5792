#include <cmath>
#include <cstdlib>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::refusal_of;
using test::tree_of;
using test::trees_of;
using test::word_of;

const std::string head =
    "CODE:\tFORM-A\n\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n$"
    "\t0\tFREE\tFREE\tIMPLICIT\n"
    "P\t1\tFREE\tFREE\tEXPLICIT\nA\t2\tFREE\tFREE\tEXPLICIT\nS\t3\tFREE\tFREE\tEXPLICIT\n\n"
    "DESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nS\tS\t+\t?\n\nFEATURES:"
    "\nNAME\tTYPE\nlength\tREAL\nTopDia\tREAL\n\n"
    "MTG:\nENTITY-CODE\t\t\tlength\tTopDia\n";

TEST(Mtg, SuccessorsAndBranches) {
  const RecordedTree tree = tree_of(head +
                                    "/P1\n\t/A1\n\t^/S1\t\t3\t2\n"  // first internode of the trunk
                                    "\t\t+A2\n\t\t^/S1\t1\t0.5\n"   // a branch on it
                                    "\t\t^<S2\t2\n"                 // the branch goes on
                                    "\t^<S2\t\t4\t1.5\n");          // and so does the trunk
  EXPECT_EQ(to_parentheses(tree.tree), "((E)E)");
  EXPECT_EQ(tree.names[0], "S1");
  EXPECT_EQ(tree.lengths, (std::vector<double>{3, 1, 2, 4}));
  EXPECT_EQ(tree.radii[0], 1);
  EXPECT_TRUE(std::isnan(tree.radii[2]));
}

TEST(Mtg, EntitiesOfALineAreAChain) {
  EXPECT_EQ(word_of(head + "/P1/A1/S1<S2+A2/S1<S2\n"), "(((E)))");
  EXPECT_EQ(word_of(head + "/P1/A1/S1\n^<S2\n"), "(E)");
}

TEST(Mtg, ScalesAreTreesOfTheirOwn) {
  const std::string text = head + "/P1\n\t/A1\n\t^/S1\n\t\t+A2\n\t\t^/S1\n\t^<S2\n\t\t+A3\n\t\t^/S1\n";
  EXPECT_EQ(word_of(text), "(E(E))");
  EXPECT_EQ(word_of(text, {"", 2}), "(EE)");
  EXPECT_EQ(word_of(text, {"", 1}), "E");
  EXPECT_NE(refusal_of(text, {"", 7}).find("no vertex of scale 7"), std::string::npos);
}

TEST(Mtg, PartsThatAreNotDescribedFurtherAreNodes) {
  EXPECT_EQ(word_of(head + "/P1/A1/S1<S2\n\t+A2\n"), "((E))");
  EXPECT_EQ(word_of(head + "/P1/A1\n\t+A2\n\t+A3\n"), "(EE)");
}

TEST(Mtg, SeveralPlantsNeedAChoice) {
  const std::string text = head + "/P1/A1/S1\n/P2/A1/S1<S2\n";
  EXPECT_NE(refusal_of(text).find("2 roots"), std::string::npos) << refusal_of(text);
  EXPECT_EQ(trees_of(text, {"all", 0}).size(), 2u);
}

TEST(Mtg, PointsGiveLengths) {
  std::string text = head;
  text.replace(text.find("length\tTopDia\n", text.find("ENTITY")), 14, "XX\tYY\tZZ\n");
  const RecordedTree tree = tree_of(text + "/P1/A1/S1\t\t\t0\t0\t0\n^<S2\t\t\t3\t4\t0\n");
  EXPECT_TRUE(std::isnan(tree.lengths[0]));
  EXPECT_EQ(tree.lengths[1], 5);
  EXPECT_TRUE(tree.radii.empty());
}

TEST(Mtg, RefusesWithLineAndColumn) {
  const struct {
    std::string text;
    const char* says;
  } cases[] = {
      {"CODE: FORM-B\nCLASSES:\n", "f:1:1: a code other than FORM-A"},
      {"CODE: FORM-A\n", "f:2:1: no entities"},
      {"CODE: FORM-A\nMTG:\nENTITY-CODE\n", "f:3:1: no classes"},
      {head + "/Q1\n", "f:21:2: entity 'Q1' of no class"},
      {head + "/P1\n\t\t/A1\n", "f:22:3: '/A1' goes on from nothing"},
      {head + "^<S1\n", "f:21:1: '^<S1' goes on from nothing"},
      {head + "/P1\nA1\n", "f:22:1: 'A1' is no entity"},
      {head + "/P1/\n", "f:21:4: '/' is no entity"},
      {head + "/P1<A1\n", "f:21:4: '<A1' after nothing of its scale"},
      {head + "/P1/A1/S1\t\t\tx\n", "f:21:13: length = 'x'"},
      {head, "f:21:1: no vertex of scale 0"},
  };
  for (const auto& c : cases)
    EXPECT_EQ(refusal_of(c.text).find(c.says), 0u) << c.says << '\n' << refusal_of(c.text);
}

}  // namespace
}  // namespace ramify
