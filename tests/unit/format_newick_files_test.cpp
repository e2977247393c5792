// Newick and NEXUS as programs write them, with the right answers by hand.
#include "support/fixtures.hpp"
#include "support/tree_files.hpp"

namespace ramify {
namespace {

TEST(NewickFiles, AreReadAsTheirProgramsWriteThem) {
  test::expect_answers({
      {"ape write.tree", "((a:1,b:2):3,c:4);\n", "3 2 / 3 1 / 2.33333 3"},
      {"ape write.tree(tree.names = TRUE)", "tree1((a:1,b:1):1,c:2);\n", "3 2 / 3 1 / 1.33333 1"},
      {"ape, a tree without lengths", "(((a,b),c),(d,e));", "5 3 1 / 5 2 1"},
      {"ape, NaN after chronos", "((a:NaN,b:NaN):NaN,c:NaN);", "3 2 / 3 1"},
      {"a label with an apostrophe inside", "(D'Arcy:1,(L'Oreal's:2,b:3):4);", "3 2 / 3 1 / 2 4"},
      {"two apostrophes inside of labels, and a comma", "(a'b,c'd);", "2 1 / 2 1"},
      {"Mesquite, quoted labels", "('a b':1,'c''d (e)':2);", "2 1 / 2 1 / 1.5 -"},
      {"phytools, double quotes", "(\"a, b\":1,(\"c\":1,d:1):1);", "3 2 / 3 1 / 1 1"},
      {"PAML codeml, branch marks", "((a,b) #1,(c,d #2),e $3);", "5 2 1 / 5 2 1"},
      {"PAML, marks behind lengths", "((a:1 #1,b:2):3 #1,c:4);", "3 2 / 3 1 / 2.33333 3"},
      {"PAML, marks in quotes for TreeView", "((a '#1',b):3 '$2',c);", "3 2 / 3 1 / - 3"},
      {"PAML, a calibration", "((a,b)'>0.3<0.5',c)'@1.2';", "3 2 / 3 1"},
      {"PAML, a line of counts", " 4 1\n((a,b),(c,d));", "4 2 1 / 4 2 1"},
      {"PHYLIP treefile, a number of trees", "2\n((a,b),(c,d));\n(a,(b,(c,d)));\n",
       "4 2 1 / 4 2 1; 4 3 / 4 1"},
      {"HyPhy", "((a{Foreground}:1,b:1)n1{Test}:2,c{Reference}:3);", "3 2 / 3 1 / 1.66667 2"},
      {"HyPhy, a mark behind the length", "((a:1{1},b:1{2}):2{3},c:3{4}){5};", "3 2 / 3 1 / 1.66667 2"},
      {"pplacer, edge numbers in braces", "((A:0.5{0},B:0.5{1}):1{2},C:1.5{3}){4};",
       "3 2 / 3 1 / 0.833333 1"},
      {"BEAST annotations", "((a[&rate=1.5]:1,b[&rate=2]:1)[&posterior=1]:[&x]2,c:3);",
       "3 2 / 3 1 / 1.66667 2"},
      {"NHX of ForesterF", "((a:1[&&NHX:S=human],b:1)90:2[&&NHX:D=Y],c:3);", "3 2 / 3 1 / 1.66667 2"},
      {"RAxML bipartitions", "((a:0.1,b:0.3)100:0.2,c:0.2,(d:0.1,e:0.3)55:0.2);",
       "5 2 1 / 5 2 1 / 0.2 0.2 -"},
      {"IQ-TREE, two supports", "((a:1,b:1)95.5/100:2,c:3);", "3 2 / 3 1 / 1.66667 2"},
      {"MrBayes, exponents", "((a:1.0e+00,b:2.0E-0):3.0e+00,c:+4.);", "3 2 / 3 1 / 2.33333 3"},
      {"FastTree, a line end in the tree", "((a:1,b:1)0.9:2,\n  c:3);", "3 2 / 3 1 / 1.66667 2"},
      {"Archaeopteryx, blanks around everything", " ( ( a : 1 , b : 1 ) : 2 , c : 3 ) ; ",
       "3 2 / 3 1 / 1.66667 2"},
      {"SplitsTree, a root with a length", "((a:1,b:1):2,c:3):5;", "3 2 / 3 1 / 1.66667 7"},
      {"DendroPy, a trifurcation", "(a,b,c);", "3 1 / 3 1"},
      {"Dendroscope, a star with one inner node", "((a,b),c,d,e);", "5 2 / 5 1"},
      {"OneZoom, one-child nodes", "(((a:1):1):1,(b:2)c:1);", "2 1 / 2 1 / 3 -"},
      {"taxonomy of NCBI, nodes without names", "(,(,),);", "4 2 / 4 1"},
      {"a label like influenza's", "(A/swine/#H1,A/duck/#H3,(A/hen/#H1,b));", "4 2 / 4 1"},
      {"PhyloNet, a network", "((a,(b)x#H1),(x#H1,c));", "refused: f:1:8: a hybrid node 'x#H1'"},
      {"extended Newick, a node without a name", "((a,(b)#H1),(#H1,c));", "refused: a hybrid node"},
      {"a length with a letter", "(a:1x,b:2);", "refused: f:1:5: a second label 'x'"},
      {"a cut-off file", "((a:1,b:2):3,c", "refused: the text ends within a tree"},
      {"JSON-like, an infinite length", "(a:Infinity,b:1);", "refused: f:1:4: a branch length"},
      {"a label with a colon", "(HLA:A:1,b:2);", "refused: put quotes around labels that hold a colon"},
      {"a label with parentheses", "(Homo(sapiens),b);",
       "refused: put quotes around labels that hold parentheses"},
      {"quotes around what looks like a network", "((a,'x#H1'),('x#H1',c));", "4 2 1 / 4 2 1"},
      {"words for missing lengths", "((a:NA,b:null):None,(c:2,d:N/A):1);", "4 2 1 / 4 2 1 / 2 1 -"},
  });
}

TEST(NexusFiles, AreReadAsTheirProgramsWriteThem) {
  const std::string translated =
      "#NEXUS\n[a comment]\nBegin taxa;\n dimensions ntax=3;\n taxlabels A 'B b' C;\nend;\n"
      "Begin trees;\n translate 1 A,\n 2 'B b',\n 3 C;\n tree one = [&R] ((1:1,2:2):3,3:4);\n"
      " tree two = [&U] (1,(2,3));\nEnd;\n";
  test::expect_answers({
      {"ape write.nexus", translated, "3 2 / 3 1 / 2.33333 3; 3 2 / 3 1"},
      {"BEAST", "#NEXUS\nbegin trees;\ntree STATE_0 [&lnP=-1.0] = [&R] ((a[&r=1]:1,b:1):2,c:3);\nend;\n",
       "3 2 / 3 1 / 1.66667 2"},
      {"PAUP, an asterisk and utree", "#nexus\nBEGIN TREES;\n\tUTREE * 'my tree' = (a,(b,c));\nENDBLOCK;\n",
       "3 2 / 3 1"},
      {"MrBayes, data first",
       "#NEXUS\nbegin data;\n format datatype=dna missing=?;\n matrix\n a ACGT\n b ACGA\n ;\nend;\n"
       "begin trees;\n tree con = (a:1,b:3);\nend;\n",
       "2 1 / 2 1 / 2 -"},
      {"Mesquite, title and link", "#NEXUS\nBEGIN TREES;\nTITLE x;\nLINK Taxa = y;\nTREE t = (a,b);\nEND;\n",
       "2 1 / 2 1"},
      {"data alone", "#NEXUS\nbegin data;\nend;\n", "refused: no tree in a NEXUS file"},
      {"a translation that is cut", "#NEXUS\nbegin trees;\ntranslate 1 a, 2",
       "refused: ends within a NEXUS command"},
      {"a tree that is cut", "#NEXUS\nbegin trees;\ntree a = (b,c", "refused: the text ends within a tree"},
  });
  const auto trees = test::trees_of(translated);
  EXPECT_EQ(trees[0].name, "f:one");
  EXPECT_EQ(trees[1].name, "f:two");
  EXPECT_EQ(trees[0].names[3], "B b");
}

TEST(NewickFiles, WhatIsSkippedIsSaid) {
  EXPECT_EQ(test::remarks_of("(a #1,b{F},c[&r=1]:nan,d:1);"),
            "f: 3 branches are without a length\n"
            "f: ignored: 1 mark of branches (#1, $1), 1 mark in braces, 1 annotation in brackets\n");
  EXPECT_EQ(test::remarks_of("[&R] (a[plain]:1,b:2):3;"), "");
  EXPECT_EQ(test::remarks_of("#NEXUS begin data; end; begin trees; tree a=(b,c); end;"),
            "f: ignored: block data\n");
  EXPECT_EQ(test::trees_of("one(a,b);two = (c,d);")[1].name, "f:two");
}

}  // namespace
}  // namespace ramify
