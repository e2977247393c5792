#include <cmath>
#include <cstdlib>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

using test::refusal_of;
using test::tree_of;
using test::trees_of;
using test::word_of;

TEST(EdgeTable, ReadsIdsAndParentsInAnyOrder) {
  EXPECT_EQ(word_of("id,parent\n1,0\n2,1\n3,1\n4,3\n5,3\n"), "(E(EE))");
  EXPECT_EQ(word_of("parent,id\nr,x\nr,y\n,r\nx,x1\nx,x2"), "((EE)E)");
  EXPECT_EQ(word_of("id,parent\n0,-1\n1,0\n2,0\n"), "(EE)");
  EXPECT_EQ(word_of("id\tparent\na\tNA\nb\ta\n"), "(E)");
  EXPECT_EQ(word_of("# a comment\r\nID;Parent\r\n\r\n1;\r\n2;1\r\n"), "(E)");
  EXPECT_EQ(word_of("id,parent\n7,0\n"), "E");
}

TEST(EdgeTable, ReadsPairs) {
  EXPECT_EQ(word_of("1 2\n1 3\n3 4\n3 5\n"), "(E(EE))");
  EXPECT_EQ(word_of("0,1\n0,2\n"), "(EE)");
  EXPECT_EQ(word_of("parent,child\na,b\na,c\n"), "(EE)");
  EXPECT_EQ(word_of("source\ttarget\nroot\tx\nroot\ty\nx\tz\n"), "((E)E)");
  const RecordedTree tree = tree_of("1 2 0.5 2\n1 3 1.5 1\n");
  EXPECT_TRUE(std::isnan(tree.lengths[0]));
  EXPECT_EQ(tree.lengths[2], 1.5);
  EXPECT_EQ(tree.radii[1], 2);
  EXPECT_EQ(tree.names[0], "1");
}

TEST(EdgeTable, KeepsGeometryAndNames) {
  const RecordedTree tree =
      tree_of("id,parent,length_mm,diameter_mm,label\n1,,10,4,\"trunk, main\"\n2,1,,3,\n3,1,2.5,NA,twig\n");
  EXPECT_EQ(tree.lengths[0], 10);
  EXPECT_TRUE(std::isnan(tree.lengths[1]));
  EXPECT_EQ(tree.radii[0], 2);
  EXPECT_TRUE(std::isnan(tree.radii[2]));
  EXPECT_EQ(tree.names[0], "trunk, main");
  EXPECT_EQ(tree.names[1], "2");
  EXPECT_EQ(tree.names[2], "twig");
}

TEST(EdgeTable, PartsItsTreesByAColumn) {
  const auto trees = trees_of("tree,id,parent\na,1,0\na,2,1\nb,1,0\n");
  ASSERT_EQ(trees.size(), 2u);
  EXPECT_EQ(trees[0].name, "f:a");
  EXPECT_EQ(trees[1].name, "f:b");
  EXPECT_EQ(trees[1].tree.node_count(), 1u);
}

TEST(EdgeTable, TakesTheRootThatIsAskedFor) {
  const std::string two = "id,parent\n1,0\n2,1\n3,1\n4,0\n5,4\n";
  EXPECT_EQ(refusal_of(two).find("f:5:1: 2 roots, among them 1 and 4"), 0u) << refusal_of(two);
  EXPECT_NE(refusal_of(two).find("--root 1"), std::string::npos);
  EXPECT_EQ(word_of(two, {"1", 0}), "(EE)");
  EXPECT_EQ(word_of(two, {"4", 0}), "(E)");
  EXPECT_EQ(word_of(two, {"2", 0}), "E");
  const auto all = trees_of(two, {"all", 0});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].name, "f#4");
  EXPECT_EQ(refusal_of(two, {"9", 0}), "f: --root 9 (no node has that id): give an id of the table");
  EXPECT_EQ(word_of("id,parent\n1,77\n2,1\n", {"1", 0}), "(E)");
}

TEST(Qsm, ReadsCylindersOfSeveralPrograms) {
  EXPECT_EQ(word_of("id,parent,extension,radius,length\n1,0,2,0.1,1\n2,1,0,0.05,1\n3,1,0,0.05,1\n"), "(EE)");
  EXPECT_EQ(word_of("ID,parentID,radius,length\n0,-1,0.1,1\n1,0,0.1,1\n"), "(E)");
  EXPECT_EQ(word_of("cyl_ID\tparent_ID\tradius_cyl\tlength\n1\t0\t0.1\t1\n2\t1\t0.1\t1\n"), "(E)");
  EXPECT_EQ(word_of("radius,length,parent,extension\n0.1,1,0,2\n0.1,1,1,3\n0.1,1,1,0\n"), "(EE)");
}

TEST(Flowlines, RunDownstream) {
  EXPECT_EQ(word_of("ID,toID\n1,0\n2,1\n3,1\n4,3\n5,3\n"), "(E(EE))");
  EXPECT_EQ(word_of("comid,tocomid,lengthkm\n10,0,1.5\n11,10,2\n"), "(E)");
  EXPECT_EQ(word_of("COMID,Hydroseq,DnHydroseq\n5,1,0\n6,2,1\n7,3,1\n"), "(EE)");
  EXPECT_EQ(word_of("comid,fromnode,tonode\n1,10,99\n2,11,10\n3,12,10\n"), "(EE)");
  EXPECT_EQ(tree_of("comid,tocomid,lengthkm\n10,0,1.5\n11,10,2\n").lengths[1], 2);
}

TEST(Flowlines, ThatPartAgainAreNoTree) {
  const std::string said = refusal_of("id,toid\n1,0\n2,1\n3,1\n4,2\n4,3\n");
  EXPECT_EQ(said.find("f:6:1: id 4 twice, first in line 5 (a river that parts again is not a tree"), 0u)
      << said;
  EXPECT_NE(refusal_of("fromnode,tonode\n10,99\n11,10\n11,98\n").find("parts again"), std::string::npos);
}

TEST(Tables, RefuseWithLineAndColumn) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"id,parent\n1,0\n2,1\n2,1\n", "f:4:1: id 2 twice, first in line 3"},
      {"id,parent\n1,0\n2,2\n", "f:3:1: node 2 is its own parent"},
      {"id,parent\n1,0\n2,7\n", "f:3:3: parent 7 of node 2 has no row"},
      {"id,parent\n1,0\n2,4\n3,2\n4,3\n", "f:3:1: a cycle of 3 nodes through node 2"},
      {"id,parent\n1,2\n2,1\n", "f:2:1: a cycle of 2 nodes through node 1"},
      {"id,parent\n1,0\n2\n", "f:3:1: a row of 1 field(s)"},
      {"id,parent\n1,0\n2,1,3\n", "f:3:5: a row of 3 field(s)"},
      {"id,parent\n,0\n", "f:2:1: an empty id"},
      {"id,parent,length\n1,0,x\n", "f:2:5: length = 'x'"},
      {"id,parent,length\n1,0,1e999\n", "f:2:5: length = '1e999'"},
      {"id,parent,radius\n1,0,-1\n", "f:2:5: radius = -1"},
      {"id,parent\n", "f:2:1: no rows"},
      {"id,parent\n\"1,0\n", "f:2:1: a quote that is never closed"},
      {"1,2\n3,4\n", "f:2:1: 2 roots, among them 1 and 3"},
      {"parent,child\na,c\nb,c\n", "f:3:3: id c twice"},
  };
  for (const auto& c : cases) EXPECT_EQ(refusal_of(c.text).find(c.says), 0u) << c.text << refusal_of(c.text);
  EXPECT_EQ(refusal_of("a,b\n", {}, TreeFormat::qsm).find("f:1:1: columns are missing"), 0u);
}

TEST(Tables, LongChainsNeedNoRecursion) {
  std::string chain = "id,parent\n1,0\n";
  for (int i = 2; i <= 100'000; ++i) chain += std::to_string(i) + ',' + std::to_string(i - 1) + '\n';
  EXPECT_EQ(tree_of(chain).tree.size(), 99'999u);
  EXPECT_NE(refusal_of("id,parent\n1,100000\n" + chain.substr(14)).find("a cycle of 100000"),
            std::string::npos);
}

}  // namespace
}  // namespace ramify
