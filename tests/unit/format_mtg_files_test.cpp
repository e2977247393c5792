// MTG as its programs and its manual write it, with the right answers by hand.
#include <algorithm>

#include "support/fixtures.hpp"
#include "support/tree_files.hpp"

namespace ramify {
namespace {

const std::string classes =
    "CLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n$\t0\tFREE\tFREE\tIMPLICIT\n"
    "P\t1\tFREE\tFREE\tEXPLICIT\nA\t2\tFREE\tFREE\tEXPLICIT\nU\t3\tFREE\tFREE\tEXPLICIT\n\n"
    "DESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nU\tU\t+\t?\nU\tU\t<\t1\n\n";

/// A file of these features: "Length\tRadius", and lines.
std::string mtg(const std::string& features, const std::string& lines,
                const std::string& code = "ENTITY-CODE\t\t\t") {
  std::string text = "CODE:\tFORM-A\n\n" + classes + "FEATURES:\nNAME\tTYPE\n";
  for (std::size_t begin = 0; begin < features.size();) {
    const std::size_t end = std::min(features.find('\t', begin), features.size());
    text += features.substr(begin, end - begin) + "\tREAL\n";
    begin = end + 1;
  }
  return text + "\nMTG:\n" + code + features + '\n' + lines;
}

TEST(MtgFiles, AreReadAsTheirManualSays) {
  const std::string fork = "/P1/A1/U1\t\t\t2\n\t+U1\t\t1\n^<U2\t\t\t3\n";  // 2, then 1 and 3
  test::expect_answers({
      {"AMAPmod, ^ and a column for each order", mtg("Length", fork), "2 1 / 2 1 / 2 2"},
      {"a scene above the plants", mtg("Length", "/Scene0\n^/P1/A1/U1\t\t\t2\n\t+U1\t\t1\n^<U2\t\t\t3\n"),
       "2 1 / 2 1 / 2 2"},
      {"class $ by its name", mtg("Length", "/$1\n^/P1/A1/U1\t\t\t2\n\t+U1\t\t1\n^<U2\t\t\t3\n"),
       "2 1 / 2 1 / 2 2"},
      {"no features, TOPO, codes in any column", mtg("", "/P1/A1/U1\n\t+U1\n\t\t+U1\n\t<U2\n^<U2\n", "TOPO"),
       "3 1 / 3 1"},
      {"two branches of one name", mtg("", "/P1/A1/U1\n\t+U1\n\t+U1\n^<U2\n", "TOPO"), "3 1 / 3 1"},
      {"a comment up to the next tab",
       mtg("Length", "/P1/A1/U1#old\t\t\t2\n\t+U1#cut\t#?\t1\n^<U2\t\t\t3#mm\n"), "2 1 / 2 1 / 2 2"},
      {"comments as lines",
       mtg("Length", "# first\n/P1/A1/U1\t\t\t2\n# second\tnot a code\n\t+U1\t\t1\n^<U2\t\t\t3\n"),
       "2 1 / 2 1 / 2 2"},
      {"a comment in the cell before a code",
       mtg("Length", "/P1/A1/U1\t\t\t2\n#cut\t+U1\t\t1\n^<U2\t\t\t3\n"), "2 1 / 2 1 / 2 2"},
      {"a comment before the code", "# by a digitiser\n#\n" + mtg("Length", fork), "2 1 / 2 1 / 2 2"},
      {"a branch in the column of its axis",
       mtg("Length", "/P1/A1/U1\t\t\t2\n^+A2\n\t/U1\t\t1\n^<U2\t\t\t3\n"), "2 1 / 2 1 / 2 2"},
      {"two branches in the column of their axis",
       mtg("Length", "/P1/A1/U1\t\t\t2\n^+A2\n\t/U1\t\t1\n^<U2\t\t\t3\n^+A3\n\t/U1\t\t1\n^<U3\t\t\t4\n"),
       "3 2 / 3 1 / 2 5"},
      {"the manual: an entity at later dates, the last length stands",
       mtg("Date\tLength",
           "/P1/A1/U1\t\t\t1/1\t1\n*\t\t\t1/2\t2\n\t+U1\t\t1/1\t1\n\t*\t\t1/3\n^<U2\t\t\t1/1\t2\n*\t\t\t1/"
           "2\t2.5\n*\t\t\t1/3\t3\n"),
       "2 1 / 2 1 / 2 2"},
      {"the manual: absolute names, their beginnings repeated",
       mtg("", "/P1/A1\n/P1/A1/U1<U2+A2/U1\n/P1/A1/U1<U2+A3/U1\n/P1/A1/U1<U2<U3\n", "TOPO"), "3 1 / 3 1"},
      {"absolute names with features, one of them twice",
       mtg("Length", "/P1/A1/U1\t\t\t2\n/P1/A1/U1+U1\t\t\t0.5\n/P1/A1/U1<U2\t\t\t3\n/P1/A1/U1+U1\t\t\t1\n"),
       "2 1 / 2 1 / 2 2"},
      {"the manual: << for what is between", mtg("", "/P1/A1/U1<<U9\n\t+U1\n^<U10\n", "TOPO"), "2 1 / 2 1"},
      {"the manual: a branch in the column right of it, an axis that goes on there",
       mtg("", "/P1/A1\n^/U1<U2\n\t+U1\n\t+U2/\n", "TOPO"), "refused: '/' is no entity"},
      {"the manual: a code that spreads over cells",
       mtg("Length", "/P1/A1\t/U1\t\t2\n\t\t+U1\t1\n\t^<U2\t\t3\n"), "2 1 / 2 1 / 2 2"},
      {"a code that spreads over cells, no features",
       mtg("", "/P1\t/A1\t/U1\n\t\t\t+U1\n\t\t\t+U1\n", "TOPO"), "2 1 / 2 1"},
      {"points", mtg("XX\tYY\tZZ", "/P1/A1/U1\t\t\t0\t0\t0\n\t+U1\t\t3\t4\t0\n^<U2\t\t\t0\t0\t7\n"),
       "2 1 / 2 1 / 6 -"},
      {"points, the first has a length",
       mtg("Length\tXX\tYY\tZZ", "/P1/A1/U1\t\t\t2\t0\t0\t0\n\t+U1\t\t\t3\t4\t0\n^<U2\t\t\t\t0\t0\t7\n"),
       "2 1 / 2 1 / 6 2"},
      {"decimal commas of a French spreadsheet",
       mtg("Length", "/P1/A1/U1\t\t\t2,5\n\t+U1\t\t1,25\n^<U2\t\t\t2,75\n"), "2 1 / 2 1 / 2 2.5"},
      {"tabs at the end of all lines",
       mtg("Length", "/P1/A1/U1\t\t\t2\t\t\t\n\t+U1\t\t1\t\t\n^<U2\t\t\t3\t\n\t\t\t\t\t\n"),
       "2 1 / 2 1 / 2 2"},
      {"a cell put in before the code of a branch",
       mtg("Length\tRadius", "/P1/A1/U1\t\t\t2\t1\n\t+U1\t\t\t1\t1\n^<U2\t\t\t3\t1\n"), "2 1 / 2 1 / 2 2"},
      {"notes right of the features",
       mtg("Length", "/P1/A1/U1\t\t\t2\tbroken\n\t+U1\t\t1\tdead\n^<U2\t\t\t3\n"), "2 1 / 2 1 / 2 2"},
      {"Windows line ends",
       [] {
         std::string text = mtg("Length", "/P1/A1/U1\t\t\t2\n\t+U1\t\t1\n^<U2\t\t\t3\n"), lines;
         for (const char c : text) lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
         return lines;
       }(),
       "2 1 / 2 1 / 2 2"},
      {"axes alone, at scale 2",
       mtg("Length", "/P1/A1\t\t\t2\n\t+A2\t\t1\n\t+A3\t\t3\n"),
       "2 1 / 2 1 / 2 2",
       {"", 2}},
      {"plants of one file", mtg("", "/P1/A1/U1\n/P2/A1/U1<U2\n", "TOPO"), "1 / 1; 1 / 1", {"all", 0}},
      {"plants of one file, no choice", mtg("", "/P1/A1/U1\n/P2/A1/U1<U2\n", "TOPO"), "refused: 2 roots"},
      {"a missing length: NA", mtg("Length", "/P1/A1/U1\t\t\t2\n\t+U1\t\tNA\n^<U2\t\t\t3\n"),
       "2 1 / 2 1 / 3 2"},
      {"a scene that is no scene", mtg("", "/Q1\n", "TOPO"), "refused: entity 'Q1' of no class"},
      {"FORM-B", "CODE:\tFORM-B\n" + classes, "refused: a code other than FORM-A"},
      {"a code in the column of a feature", mtg("Length", "/P1/A1/U1\t\t\t2\n\t\t\t+U1\n"),
       "refused: the code '+U1' right of the columns for codes"},
      {"a star at the beginning", mtg("Length", "*\t\t\t2\n"), "refused: '*' after nothing"},
      {"a class that is not there", mtg("", "/P1/A1/X1\n", "TOPO"), "refused: entity 'X1' of no class"},
  });
}

TEST(MtgFiles, WhatIsNotReadIsSaid) {
  EXPECT_EQ(test::remarks_of(mtg("Length\tcolour", "/P1/A1/U1\t\t\t2\tred\n\t\t\t7\tgreen\n*\t\t\t3\n")),
            "f: ignored: 1 row without a code, 1 row of an earlier date, feature colour\n");
  EXPECT_EQ(test::remarks_of(mtg("Length", "/P1/A1/U1\t\t\t2\tnote\n")),
            "f: ignored: 1 field right of the features\n");
  EXPECT_EQ(test::remarks_of(mtg("", "/P1/A1/U1\t\tnote\n", "TOPO")),
            "f: ignored: 1 field right of the code\n");
}

}  // namespace
}  // namespace ramify
