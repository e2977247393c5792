// Bad input: one clear line on standard error, exit code 2, nothing written.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

struct Case {
  const char* name;
  const char* arguments;
  const char* says;

  friend std::ostream& operator<<(std::ostream& out, const Case& bad) { return out << bad.name; }
};

class BadInput : public testing::TestWithParam<Case> {};

TEST_P(BadInput, IsOneClearLineAndExitCode2) {
  const Ran ran = ramify(GetParam().arguments);
  EXPECT_EQ(ran.code, 2) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find(GetParam().says), std::string::npos) << ran.err;
}

INSTANTIATE_TEST_SUITE_P(
    CommandLine, BadInput,
    testing::Values(
        Case{"UnknownModel", "sample --model bts --n 10", "did you mean bst"},
        Case{"UnknownStatistic", "sample --model bst --n 10 --statistics strahlr", "did you mean strahler"},
        Case{"StatisticTwice", "sample --model bst --n 10 --statistics height,height", "given twice"},
        Case{"UnknownVerb", "sampel --model bst", "did you mean sample"},
        Case{"UnknownOption", "sample --model bst --n 10 --sizes 3", "--help"}, Case{"NoVerb", "", "--help"},
        Case{"ProbabilityAboveOne", "sample --model 'dst(1.5)' --n 10", "(0,1)"},
        Case{"ProbabilityZero", "sample --model 'patricia(0)' --n 10", "(0,1)"},
        Case{"ProbabilityOne", "sample --model 'patricia(1)' --n 10", "(0,1)"},
        Case{"ParameterNan", "sample --model 'patricia(nan)' --n 10", "not a finite number"},
        Case{"ParameterInf", "sample --model 'beta(inf,1)' --n 10", "not a finite number"},
        Case{"ParameterZero", "sample --model 'beta(0,1)' --n 10", "[1e-9,1e9]"},
        Case{"ParameterAtItsBound", "sample --model 'aldous(-2)' --n 10", "above -2"},
        Case{"ParameterCount", "sample --model 'beta(1)' --n 10", "takes 2"},
        Case{"FileWithoutPath", "sample --model file --n 10", "write file(PATH)"},
        Case{"FileWithEmptyPath", "sample --model 'file( )' --n 10", "write file(PATH)"},
        Case{"FileThatIsNotThere", "sample --model 'file(no_such.csv)' --n 10", "cannot read 'no_such.csv'"},
        Case{"FileThatIsAFolder", "sample --model 'file(docs)' --n 10", "cannot read 'docs'"},
        Case{"FileNeverClosed", "sample --model 'file(law.csv' --n 10", "a '(' without its ')'"},
        Case{"NegativeSize", "sample --model bst --n=-5", "whole number"},
        Case{"FractionalSize", "sample --model bst --n 10.5", "whole number"},
        Case{"SizeAbove2To62", "sample --model bst --n 4611686018427387905", "2^62"},
        Case{"FloorModelAbove2To50", "sample --model 'beta(2,2)' --n 2^51", "reaches every index"},
        Case{"TooMuchWork", "sample --model bst --n 10000000000000 --replicates 2 --no-graft", "--yes"},
        Case{"LawOfAGrownModel", "law --model 'trie(0.3)' --n 10 --statistic strahler", "split trees"},
        Case{"RamificationThatIsNotThere", "sample --model 'ramification(no_such.csv)' --n 3",
             "cannot read 'no_such.csv'"},
        Case{"TreesThatNeverEnd", "sample --model 'branching(0,0,1)' --n 100", "1e+09 or less"},
        Case{"FirAboveAThird", "sample --model 'ternary(0.4)' --n 10", "1/3"},
        Case{"FormulaThatDoesNotParse", "sample --model 'node_beta(d+,1)' --n 10", "position"},
        Case{"FormulaOutOfItsDomain", "sample --model 'node_dst(d)' --n 10", "at d = 1, size = 10"},
        Case{"UnknownPreset", "sample --preset aple", "did you mean apple"},
        Case{"PresetAndModel", "sample --preset apple --model bst", "leave one of them out"},
        Case{"NeitherPresetNorModel", "sample --n 10", "neither --preset nor"},
        Case{"TrieOfNothing", "trie", "without --n or --strings"},
        Case{"TrieOfNoStrings", "trie --n 0", "one string at least"},
        Case{"TrieOfNoProbability", "trie --n 10 --p 2", "(0,1)"},
        Case{"TrieOfOneStringTwice", "trie --strings 01,01", "never part"},
        Case{"HybridOfAnotherLetter",
             "sample --model 'hybrid(data/ramification_bst.csv,data/ramification_bst.csv,AC)' --n 2",
             "neither A nor B"},
        Case{"TestOfNoFile", "test no_such.txt --model bst", "cannot read 'no_such.txt'"},
        Case{"TestOfNoTree", "test LICENSE --model bst", "LICENSE:1"},
        Case{"TestWithFewTrees", "test LICENSE --model bst --replicates 10", "99 or more"},
        Case{"NoTrees", "sample --model bst --n 10 --replicates 0", "no tree"},
        Case{"NoThreads", "sample --model bst --n 10 --threads 0", "from 1 to 1024"},
        Case{"UnknownFormat", "sample --model bst --n 10 --format nwk", "parens"},
        Case{"UnwritableOutput", "sample --model bst --n 10 -o /proc/no/such/file.csv", "/proc/no/such"},
        Case{"UnwritableFolder", "run configs/quick/catalan_order.toml --out /proc/no/such", "/proc/no/such"},
        Case{"FolderThatIsAFile", "run configs/quick/catalan_order.toml --out LICENSE", "Not a directory"},
        Case{"VerdictsIntoAFile", "reproduce --claim C22 --out LICENSE", "Not a directory"},
        Case{"ConfigsThatAreNotThere", "reproduce --configs nothere", "no configs in 'nothere/quick'"},
        Case{"NoConfig", "run configs/quick/no_such.toml", "no_such.toml"},
        Case{"UnknownScale", "reproduce --scale medium", "quick"},
        Case{"UnknownClaim", "reproduce --claim C200", "did you mean C20"},
        Case{"UnknownList", "list model", "did you mean models"},
        Case{"UnknownTheoryModel", "theory --model catlan", "did you mean catalan"},
        Case{"LawOfUnknownStatistic", "law --model bst --n 10 --statistic strahlr", "did you mean strahler"},
        Case{"LawOfASizeThatIsKnown", "law --model bst --n 10 --statistic size",
             "strahler, registers, height, depth"},
        Case{"LawOfUnknownModel", "law --model bts --n 10 --statistic height", "did you mean bst"},
        Case{"LawWithoutSize", "law --model bst --statistic height", "--help"},
        Case{"LawCovariancesOfOneNumber", "law --model bst --n 10 --statistic height --covariances",
             "orders"},
        Case{"LawTwoTables", "law --model bst --n 10 --statistic orders --covariances --moments", "--help"},
        Case{"LawSizeTwice", "law --model bst --n 10,10 --statistic height", "given twice"},
        Case{"LawGridWithoutCount", "law --model bst --n 10:100 --statistic height", "from:to:count"},
        Case{"LawFractionalSize", "law --model bst --n 10,10.5 --statistic height", "whole number"},
        Case{"LawAbove2To50", "law --model 'beta(2,2)' --n 2^51 --statistic height --exact",
             "reaches every index"},
        Case{"LawLargerThanMemory", "law --model bst --n 10,2^40 --statistic strahler --exact",
             "PB of memory"},
        Case{"LawTooLong", "law --model bst --n 5e5 --statistic depth --exact", "--yes"},
        Case{"NoDataFile", "fit data/no_such.csv", "no_such.csv"},
        Case{"UnknownObservable", "fit data/species.csv --observable order", "ratio"}),
    [](const auto& test) { return test.param.name; });

/// Every refusal of a config names its place in the file.
TEST(BadConfig, NamesFileLineAndColumn) {
  const Scratch scratch;
  const std::string head = "models = [\"bst\"]\nstatistics = [\"strahler\"]\n";
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"n = [10]\nreplicates = 5\nstatistcs = []\n", "statistics"},
      {"n = [10]\nreplicates = \"5\"\n", ":4:"},
      {"n = []\nreplicates = 5\n", ":3:"},
      {"n = [0]\nreplicates = 5\n", ":3:"},
      {"n = [10, 10]\nreplicates = 5\n", ":3:"},
      {"n = [10.5]\nreplicates = 5\n", ":3:"},
      {"n = [-1]\nreplicates = 5\n", ":3:"},
      {"n = [10\nreplicates = 5\n", ":4:"},
  };
  for (const auto& c : cases) {
    const std::string config = scratch.file("bad.toml", head + c.text);
    const Ran ran = ramify("run " + config + " --out " + (scratch / "runs").string());
    EXPECT_EQ(ran.code, 2) << c.text;
    EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
    EXPECT_NE(ran.err.find("bad.toml:"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.text << ran.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "runs"));
  }
}

/// Every refusal of a table of splits names its place in the file.
TEST(BadSplitTable, NamesFileLineAndColumn) {
  const Scratch scratch;
  const std::string good = "n,left,probability\n2,0,0.5\n2,1,0.5\n";
  const struct {
    std::string text;
    const char* says;
  } cases[] = {
      {"", "law.csv: no header"},
      {"n,left,probability\n", "law.csv: no rows"},
      {"n,left,p\n2,0,1\n", "no column 'probability'"},
      {good + "3,0,1,1\n", ":4:7: a row of 4 field(s)"},
      {good + "3,3,1\n", ":4:3: left = 3 in a tree of n = 3"},
      {good + "3,-1,1\n", ":4:3: left = '-1' (not a whole number"},
      {good + "3,0.5,1\n", ":4:3: left = '0.5' (not a whole number"},
      {good + "0,0,1\n", ":4:1: n = 0"},
      {good + "x,0,1\n", ":4:1: n = 'x' (not a whole number"},
      {good + "3,0,-0.5\n", ":4:5: probability = -0.5"},
      {good + "3,0,nan\n", ":4:5: probability = 'nan' (not a finite number"},
      {good + "3,0,inf\n", ":4:5: probability = 'inf' (not a finite number"},
      {good + "3,0,\n", ":4:5: probability = '' (a number is needed"},
      {good + "3,0,0.5\n3,1,0.4\n", ":4: the probabilities of n = 3 sum to 0.9"},
      {good + "3,0,0\n", ":4: the probabilities of n = 3 sum to 0 "},
      {good + "3,0,0.5\n3,1,0.500000002\n", ":4: the probabilities of n = 3 sum to 1.000000002"},
      {good + "3,0,1e308\n3,1,1e308\n", ":4: the probabilities of n = 3 sum to"},
      {good + "3,0,0.5\n2,1,0.5\n3,2,0.5\n", ":5:3: n = 2, left = 1 twice (line 3"},
      {good + "4,0,1\n", ":4:1: n = 4, and no row of n = 3"},
      {"n,left,probability\n3,0,1\n", ":2:1: n = 3, and no row of n = 2"},
      {"n,left,probability\n1,0,0.5\n", ":2: the probabilities of n = 1 sum to 0.5"},
      {good + "18446744073709551615,0,1\n", "and no row of n = 3"},
      {good + "3,\"0,1\n", ":4:3: a quote that is never closed"},
  };
  for (const auto& c : cases) {
    const std::string model = "'file(" + scratch.file("law.csv", c.text) + ")'";
    for (const char* verb : {"law --n 2 --statistic height --model ", "sample --n 2 --model "}) {
      const Ran ran = ramify(verb + model);
      EXPECT_EQ(ran.code, 2) << c.text;
      EXPECT_EQ(ran.out, "");
      EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
      EXPECT_NE(ran.err.find("law.csv:"), std::string::npos) << ran.err;
      EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.says << '\n' << ran.err;
    }
  }
}

TEST(BadSplitTable, InAConfigNamesBothFiles) {
  const Scratch scratch;
  const std::string law = scratch.file("law (1).csv", "n,left,probability\n2,2,1\n");
  const std::string config =
      scratch.file("bad.toml", "models = [\"bst\", \"file(" + law +
                                   ")\"]\nn = [2]\nreplicates = 5\nstatistics = [\"strahler\"]\n");
  const Ran ran = ramify("run " + config + " --out " + (scratch / "runs").string());
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find("bad.toml:1:"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("law (1).csv:2:3: left = 2"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "runs"));
}

TEST(BadSplitTable, IsAskedForNoMoreThanItHolds) {
  const Scratch scratch;
  const std::string model = "'file(" + scratch.file("law.csv", "n,left,probability\n2,0,1\n") + ")'";
  for (const char* verb : {"law --n 2,3 --statistic height --model ", "sample --n 3 --model "}) {
    const Ran ran = ramify(verb + model);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
    EXPECT_NE(ran.err.find("its table ends at n = 2"), std::string::npos) << ran.err;
  }
}

TEST(BadOutput, AFullDiskIsSaidInOneLine) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Ran ran = shell(std::string(RAMIFY_PROGRAM) + " sample --model bst --n 10 > /dev/full");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
}

}  // namespace
}  // namespace ramify::test
