#include <cmath>
#include <cstdlib>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/format/newick.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::refusal_of;
using test::tree_of;
using test::trees_of;
using test::word_of;

TEST(Newick, ReadsEveryShapeOfItsGrammar) {
  EXPECT_EQ(word_of("(,,(,));"), "(EE(EE))");
  EXPECT_EQ(word_of("(A,B,(C,D));"), "(EE(EE))");
  EXPECT_EQ(word_of("(A,B,(C,D)E)F;"), "(EE(EE))");
  EXPECT_EQ(word_of("(:0.1,:0.2,(:0.3,:0.4):0.5);"), "(EE(EE))");
  EXPECT_EQ(word_of("((B:0.2,(C:0.3,D:0.4)E:0.5)F:0.1)A;"), "((E(EE)))");
  EXPECT_EQ(word_of("A;"), "E");
  EXPECT_EQ(word_of("A:0.5;"), "E");
  EXPECT_EQ(word_of("((((A))));"), "((((E))))");
  EXPECT_EQ(word_of(" ( a , b )\r\n\t; \n"), "(EE)");
}

TEST(Newick, KeepsLabelsAndLengths) {
  const RecordedTree tree = tree_of("((B:0.2,(C:3e-1,'D d''s':-4):+5.5)F,:1)A;");
  ASSERT_EQ(tree.tree.node_count(), 7u);
  const std::vector<std::string> labels{"A", "F", "B", "", "C", "D d's", ""};
  for (std::size_t node = 0; node < 7; ++node) EXPECT_EQ(tree.names[node], labels[node]);
  EXPECT_TRUE(std::isnan(tree.lengths[0]));
  EXPECT_TRUE(std::isnan(tree.lengths[1]));
  EXPECT_EQ(tree.lengths[2], 0.2);
  EXPECT_EQ(tree.lengths[3], 5.5);
  EXPECT_EQ(tree.lengths[5], -4);
  EXPECT_TRUE(tree.radii.empty());
  EXPECT_TRUE(tree_of("(A,B);").lengths.empty());
  EXPECT_TRUE(tree_of("(,);").names.empty());
}

TEST(Newick, SkipsCommentsAnywhere) {
  EXPECT_EQ(word_of("[&R] (a[x[nested]]:1[&&NHX:S=e],[(](b,c)[,]:2)[;];"), "(E(EE))");
  EXPECT_EQ(word_of("[&U](a,b,c);"), "(EEE)");
}

TEST(Newick, LabelsHoldWhatTheyMust) {
  const RecordedTree tree = tree_of("('a(b);c',Homo sapiens ,x_y,'',\xC3\xA9);");
  EXPECT_EQ(tree.names[1], "a(b);c");
  EXPECT_EQ(tree.names[2], "Homo sapiens");
  EXPECT_EQ(tree.names[3], "x_y");
  EXPECT_EQ(tree.names[4], "");
  EXPECT_EQ(tree.names[5], "\xC3\xA9");
}

TEST(Newick, NumbersTooSmallForADoubleAreZero) {
  EXPECT_EQ(tree_of("(a:1e-400,b:-1e-400);").lengths[1], 0);
}

TEST(Newick, NamesTreesByTheirPlace) {
  EXPECT_EQ(tree_of("(a,b);").name, "f");
  const auto lines = trees_of("(a,b);\n(c,\nd);\r\n\n(e,f);");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].name, "f:1");
  EXPECT_EQ(lines[1].name, "f:2");
  EXPECT_EQ(lines[2].name, "f:5");
  const auto together = trees_of("(a,b);(c,d);\n(e,f);");
  EXPECT_EQ(together[0].name, "f:1:1");
  EXPECT_EQ(together[1].name, "f:1:7");
  EXPECT_EQ(together[2].name, "f:2");
}

TEST(Newick, ByteOrderMarkAndMixedLineEndsAreNothing) {
  const auto trees = trees_of("\xEF\xBB\xBF(a,b);\r\n(c,d);\r(e,f);\n");
  ASSERT_EQ(trees.size(), 3u);
  EXPECT_EQ(trees[2].name, "f:3");
}

TEST(Newick, RefusesWithTheColumn) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"(a,b)", "f:1:6: the text ends within a tree"},
      {"(a,(b,c);", "f:1:9: a ';' with 1 '(' left open"},
      {"((a,b)", "f:1:7: the text ends within a tree (1 '(' left open"},
      {"(a,b));", "f:1:6: a ')' without its '('"},
      {"(a,b),c;", "f:1:6: a ',' outside of parentheses"},
      {"(a,());", "f:1:5: an empty pair of parentheses"},
      {"(a,b)(c,d);", "f:1:6: a '(' after a node"},
      {"(a b(c,d),e);", "f:1:5: a '(' after a node"},
      {"(a,b)c 'd';", "f:1:8: a second label 'd'"},
      {"(a:1b,c);", "f:1:5: a second label 'b'"},
      {"(a:1:2,c);", "f:1:5: a second length"},
      {"(a,b:);x{", "f:1:9: a '{' that is never closed"},
      {"({1}a,b);", "f:1:2: a '{' without a node"},
      {"(a,#H1);", "f:1:4: a hybrid node '#H1'"},
      {"(a:x,b);", "f:1:4: a branch length 'x'"},
      {"(a:1e999,b);", "f:1:4: a branch length '1e999'"},
      {"(a:inf,b);", "f:1:4: a branch length 'inf'"},
      {"(a,'b);", "f:1:4: a quote that is never closed"},
      {"(a,b[c);", "f:1:5: a comment that is never closed"},
      {"(a,b]);", "f:1:5: a ']' without its '['"},
      {"(a,b);\n;", "f:2:1: a ';' without a tree"},
      {"(a,b);\r\n(\xC3\xA9,b));", "f:2:6: a ')' without its '('"},
      {"((a,x#H1),(b,x#H1));", "f:1:5: a hybrid node 'x#H1'"},
      {"(a,b);junk", "f:1:11: the text ends within a tree"},
  };
  for (const auto& c : cases) {
    const std::string said = refusal_of(c.text);
    EXPECT_EQ(said.find(c.says), 0u) << c.text << " -> " << said;
  }
  EXPECT_EQ(refusal_of(std::string("(a,\0b);", 7), {}, TreeFormat::newick).find("f:1:4: a zero byte"), 0u);
}

TEST(Newick, NeedsNoRecursionAndNoSquareOfTheSize) {
  const std::size_t size = 200'000;
  const std::string caterpillar = std::string(size, '(') + "a" + [&] {
    std::string rest;
    for (std::size_t i = 0; i < size; ++i) rest += ",b)";
    return rest + ";";
  }();
  EXPECT_EQ(tree_of(caterpillar).tree.size(), size);
  std::string star = "(a";
  for (std::size_t i = 1; i < size; ++i) star += ",b";
  EXPECT_EQ(tree_of(star + ");").tree.arity(0), size);
}

TEST(Newick, WritesWhatItReads) {
  for (const char* text : {"((B:0.2,(C:0.3,'D d''s':4)E:0.5)F:0.1)A;\n", "(a,b,,c);\n", "x;\n"})
    EXPECT_EQ(write_newick(tree_of(text)), text);
  EXPECT_EQ(write_newick({{}, from_parentheses("(E((EE)E))"), {}, {}, {}}), "(1,((2,3),4));\n");
}

}  // namespace
}  // namespace ramify
