// SWC as programs write it, with and without a header, with the right answers by hand.
#include "support/fixtures.hpp"
#include "support/tree_files.hpp"

namespace ramify {
namespace {

// One cell throughout, unless it says otherwise: a soma at the origin, a neurite (0,10,0) that forks to
// (-3,14,0) and (3,14,0), each 5 away, and one to (0,-6,8), 10 away: tips 3, lengths 5, 5 and 10.
const char* const cell_answer = "3 2 / 3 1 / 6.66667 10";

TEST(SwcFiles, AreReadAsTheirProgramsWriteThem) {
  test::expect_answers({
      {"neuromorpho.org",
       "# ORIGINAL_SOURCE x\n#\n1 1 0 0 0 5 -1\n2 3 0 10 0 1 1\n3 3 -3 14 0 .5 2\n4 3 3 14 0 .5 2\n"
       "5 3 0 -6 8 .5 1\n",
       cell_answer},
      {"Neurolucida by NLMorphologyConverter, blanks in front",
       "   1 1 0.0 0.0 0.0 5.0 -1\n   2 3 0.0 10.0 0.0 1.0 1\n  3 3 -3 14 0 1 2\n 4 3 3 14 0 1 2\n 5 3 0 -6 "
       "8 1 1\n",
       cell_answer},
      {"TREES toolbox, tabs and blanks",
       "1\t1 0\t0 0 5\t-1\n2\t3 0 10 0 1\t1\n3 3\t-3 14 0 1 2\n4 3 3\t14 0 1 2\n5 3 0 -6 8 1 1", cell_answer},
      {"Vaa3D, a commented header with commas",
       "##n,type,x,y,z,radius,parent\n1 1 0 0 0 5 -1\n2 3 0 10 0 1 1\n3 3 -3 14 0 1 2\n"
       "4 3 3 14 0 1 2\n5 3 0 -6 8 1 1\n",
       cell_answer},
      {"Vaa3D eswc, more columns",
       "1 1 0 0 0 5 -1 0 1 2\n2 3 0 10 0 1 1 0 1 2\n3 3 -3 14 0 1 2 0 1 2\n4 3 3 14 0 1 2 0 1 2\n"
       "5 3 0 -6 8 1 1 0 1 2\n",
       cell_answer},
      {"SNT, comments behind points",
       "1 1 0 0 0 5 -1 # soma\n2 3 0 10 0 1 1#d\n3 3 -3 14 0 1 2\n# between\n4 3 3 14 0 1 2\n"
       "5 3 0 -6 8 1 1 #end\n",
       cell_answer},
      {"numpy.savetxt, all columns as floats",
       "1.0 1.0 0.0 0.0 0.0 5.0 -1.0\n2.0 3.0 0.0 10.0 0.0 1.0 1.0\n"
       "3.0 3.0 -3 14 0 1 2.0\n4.0 3.0 3 14 0 1 2.0\n5.0 3.0 0 -6 8 1 1.0\n",
       cell_answer},
      {"numpy.savetxt, its format as it comes",
       "1.000000000000000000e+00 1.000000000000000000e+00 0 0 0 5 -1.000000000000000000e+00\n"
       "2.000000000000000000e+00 3 0 10 0 1 1.000000000000000000e+00\n3 3 -3 14 0 1 2\n4 3 3 14 0 1 2\n5 3 0 "
       "-6 8 1 1\n",
       cell_answer},
      {"leading zeros",
       "001 1 0 0 0 5 -1\n002 3 0 10 0 1 001\n003 3 -3 14 0 1 2\n004 3 3 14 0 1 2\n005 3 0 -6 8 1 1\n",
       cell_answer},
      {"ids from 0", "0 1 0 0 0 5 -1\n1 3 0 10 0 1 0\n2 3 -3 14 0 1 1\n3 3 3 14 0 1 1\n4 3 0 -6 8 1 0\n",
       cell_answer},
      {"points in any order",
       "5 3 0 -6 8 1 1\n4 3 3 14 0 1 2\n3 3 -3 14 0 1 2\n2 3 0 10 0 1 1\n1 1 0 0 0 5 -1\n", cell_answer},
      {"the soma in the middle",
       "3 3 -3 14 0 1 -1\n2 3 0 10 0 1 3\n4 3 3 14 0 1 2\n1 1 0 0 0 5 2\n5 3 0 -6 8 1 1\n", cell_answer},
      {"three soma points",
       "1 1 0 0 0 5 -1\n6 1 0 -5 0 5 1\n7 1 0 5 0 5 1\n2 3 0 10 0 1 1\n3 3 -3 14 0 1 2\n4 3 3 14 0 1 2\n"
       "5 3 0 -6 8 1 1\n",
       cell_answer},
      {"three soma points, a neurite on the third: (0,5,0) to (0,10,0)",
       "1 1 0 0 0 5 -1\n6 1 0 -5 0 5 1\n7 1 0 5 0 5 1\n2 3 0 10 0 1 7\n3 3 -3 14 0 1 2\n4 3 3 14 0 1 2\n5 3 "
       "0 -6 8 1 1\n",
       "3 2 / 3 1 / 6.66667 5"},
      {"a CSV without a header",
       "1,1,0,0,0,5,-1\n2,3,0,10,0,1,1\n3,3,-3,14,0,1,2\n4,3,3,14,0,1,2\n5,3,0,-6,8,1,1\n", cell_answer},
      {"semicolons and decimal commas",
       "1;1;0,0;0,0;0,0;5,0;-1\n2;3;0,0;10,0;0,0;1,5;1\n3;3;-3,0;14,0;0,0;1,5;2\n"
       "4;3;3,0;14,0;0,0;1,5;2\n5;3;0,0;-6,0;8,0;1,5;1\n",
       cell_answer},
      {"semicolons, a decimal comma in every number",
       "1,0;1,0;0,0;0,0;0,0;5,0;-1,0\n2,0;3,0;0,0;10,0;0,0;1,0;1,0\n3,0;3,0;-3,0;14,0;0,0;1,0;2,0\n"
       "4,0;3,0;3,0;14,0;0,0;1,0;2,0\n5,0;3,0;0,0;-6,0;8,0;1,0;1,0\n",
       cell_answer},
      {"blanks, a decimal comma in every number",
       "1,0 1,0 0,0 ,0 0,0 5,0 -1,0\n2,0 3,0 0,0 10,0 0,0 1,0 1,0\n3,0 3,0 -3,0 14,0 0,0 1,0 2,0\n"
       "4,0 3,0 3,0 14,0 0,0 1,0 2,0\n5,0 3,0 0,0 -6,0 8,0 1,0 1,0\n",
       cell_answer},
      {"commas with a blank behind them",
       "1, 1, 0, 0, 0, 5, -1\n2, 3, 0, 10, 0, 1, 1\n3, 3, -3, 14, 0, 1, 2\n4, 3, 3, 14, 0, 1, 2\n"
       "5, 3, 0, -6, 8, 1, 1\n",
       cell_answer},
      {"commas with a blank before them",
       "1 ,1 ,0 ,0 ,0 ,5 ,-1\n2 ,3 ,0 ,10 ,0 ,1 ,1\n3 ,3 ,-3 ,14 ,0 ,1 ,2\n4 ,3 ,3 ,14 ,0 ,1 ,2\n"
       "5 ,3 ,0 ,-6 ,8 ,1 ,1\n",
       cell_answer},
      {"many semicolons in a comment",
       "1 1 0 0 0 5 -1 # a;b;c;d;e;f;g\n2 3 0 10 0 1 1\n3 3 -3 14 0 1 2\n4 3 3 14 0 1 2\n5 3 0 -6 8 1 1\n",
       cell_answer},
      {"navis to_csv: label has the type, type the kind of node",
       "node_id,label,x,y,z,radius,parent_id,type\n1,1,0,0,0,5,-1,root\n2,3,0,10,0,1,1,branch\n3,3,-3,14,0,1,"
       "2,end\n"
       "4,3,3,14,0,1,2,end\n5,3,0,-6,8,1,1,end\n",
       cell_answer},
      {"nat write.csv: row names, W is a diameter",
       "\"\",\"PointNo\",\"Label\",\"X\",\"Y\",\"Z\",\"W\",\"Parent\"\n\"1\",1,1,0,0,0,10,-1\n"
       "\"2\",2,3,0,10,0,2,1\n\"3\",3,3,-3,14,0,1,2\n\"4\",4,3,3,14,0,1,2\n\"5\",5,3,0,-6,8,1,1\n",
       cell_answer},
      {"R write.table: a header one field short",
       "PointNo Label X Y Z W Parent\n1 1 1 0 0 0 10 -1\n2 2 3 0 10 0 2 1\n3 3 3 -3 14 0 1 2\n"
       "4 4 3 3 14 0 1 2\n5 5 3 0 -6 8 1 1\n",
       cell_answer},
      {"CATMAID export",
       "treenode_id,parent_treenode_id,x,y,z,radius\n1,null,0,0,0,5\n2,1,0,10,0,1\n3,2,-3,14,0,1\n"
       "4,2,3,14,0,1\n5,1,0,-6,8,1\n",
       cell_answer},
      {"pandas, types by name",
       "sample,structure,x,y,z,r,parent\n1,soma,0,0,0,5,\n2,dendrite,0,10,0,1,1.0\n"
       "3,dendrite,-3,14,0,1,2.0\n4,apical,3,14,0,1,2.0\n5,axon,0,-6,8,1,1.0\n",
       cell_answer},
      {"columns in another order",
       "parent id radius z y x type\n-1 1 5 0 0 0 1\n1 2 1 0 10 0 3\n2 3 1 0 14 -3 3\n2 4 1 0 14 3 3\n"
       "1 5 1 8 -6 0 3\n",
       cell_answer},
      {"old line ends", "1 1 0 0 0 5 -1\r2 3 0 10 0 1 1\r3 3 -3 14 0 1 2\r4 3 3 14 0 1 2\r5 3 0 -6 8 1 1\r",
       cell_answer},
      {"radii of -1: unknown",
       "1 1 0 0 0 5 -1\n2 3 0 10 0 -1 1\n3 3 -3 14 0 -1 2\n4 3 3 14 0 -1 2\n5 3 0 -6 8 -1 1\n", cell_answer},
      {"airways, no soma: lengths 10 and 5, 5",
       "1 0 0 0 0 5 -1\n2 0 0 10 0 1 1\n3 0 -3 14 0 1 2\n4 0 3 14 0 1 2\n", "2 1 / 2 1 / 5 10"},
      {"a neurite that is not joined",
       "0 1 0 0 0 5 -1\n1 3 0 5 0 1 -1\n2 3 0 10 0 1 1\n3 3 -3 14 0 1 2\n4 3 3 14 0 1 2\n",
       "2 1 / 2 1 / 5 5",
       {"neurites", 0}},
      {"two cells in a file", "1 1 0 0 0 5 -1\n2 3 0 10 0 1 1\n3 1 90 0 0 5 -1\n4 3 90 4 0 1 3\n",
       "refused: 2 roots, among them 1 and 3"},
      {"1 and 01 as two points", "1 1 0 0 0 5 -1\n01 3 0 10 0 1 1\n",
       "refused: f:2:1: ids 01 and 1 (line 1) are one number"},
      {"two mirrored parents", "1 3 0 0 0 1 2\n2 3 0 1 0 1 1\n", "refused: a cycle of 2 nodes"},
      {"a cut-off line below a commented header",
       "#id type x y z strahler radius parent\n1 1 0 0 0 1 5 -1\n2 3 0 1 0 1 1\n",
       "refused: f:3:13: a line of 7 field(s)"},
      {"a cut-off line", "1 1 0 0 0 5 -1\n2 3 0 10\n", "refused: f:2:7: a line of 4 field(s)"},
  });
}

TEST(SwcFiles, WhatIsDoubtfulIsSaid) {
  EXPECT_EQ(test::remarks_of("1 1 0 0 0 5 -1\n2 3 0 10 0 1 1\n"), "");
  EXPECT_EQ(test::remarks_of("1 1 0 0 0 1 -1\n2 1 0 5 0 1 1\n"),
            "f: all 2 points are typed soma (1): they are one node\n"
            "f: a soma point lies up to 5 radii from the first: branches typed soma (1) are lost in it\n");
  EXPECT_EQ(test::remarks_of("1 3 0 0 0 1 -1\n2 1 0 5 0 1 1\n"),
            "f: the soma, point 2, is the root: the file begins at point 1\n");
  EXPECT_EQ(test::remarks_of("1 1 0 0 0 5 -1\n2 3 0 9 0 1 1\n3 1 0 20 0 5 2\n"),
            "f: 2 groups of soma points that are not joined to each other: the first is the root\n"
            "f: a soma point lies up to 4 radii from the first: branches typed soma (1) are lost in it\n");
  EXPECT_EQ(test::remarks_of("1 0 0 0 0 -1 -1 9\n2 0 0 1 0 1 1 9\n"),
            "f: a point is without a radius (-1 or none)\nf: ignored: 2 fields after the seventh\n");
  EXPECT_EQ(test::remarks_of("node_id,label,x,y,z,radius,parent_id,type\n1,1,0,0,0,1,-1,root\n"),
            "f: ignored: column type\n");
  EXPECT_EQ(test::remarks_of("id,type,x,y,z,radius,parent,strahler\n1,1,0,0,0,1,-1,1\n"),
            "f: ignored: column strahler\n");
}

}  // namespace
}  // namespace ramify
