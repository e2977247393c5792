#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

std::string line(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string found;
  for (std::size_t i = 0; i < number; ++i) std::getline(lines, found);
  return found;
}

TEST(Sample, OneReplicateIsReplayedAlone) {
  const std::string what =
      "sample --model 'beta(0.3,2)' --n 500 --seed 9 --statistics strahler,height,depth,streams ";
  const Ran many = ramify(what + "--replicates 6");
  const Ran one = ramify(what + "--replicate 4");
  ASSERT_EQ(many.code, 0) << many.err;
  EXPECT_EQ(count_lines(many.out), 7u);
  EXPECT_EQ(line(one.out, 2), line(many.out, 6));
  EXPECT_NE(line(one.out, 2), line(many.out, 5));
}

TEST(Sample, TreesOfParensAreTheTreesOfTheStatistics) {
  const Ran words = ramify("sample --model 'split(0.25)' --n 15 --format parens");
  EXPECT_EQ(words.out, "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))\n");  // catalogue A6
  const Ran counts =
      ramify("sample --model 'split(0.25)' --n 15 --statistics size,strahler,height,nodes,streams");
  EXPECT_EQ(line(counts.out, 2), "split(0.25),15,1996,0,15,2,8,16,11,4,0,0,16,5,1,0,0");
}

TEST(Sample, TreesOfParensAreThoseGrownWithoutGrafts) {
  for (const std::string model : {"bst", "'patricia(0.23)'", "'beta(2,3)'", "catalan"}) {
    const std::string what = "sample --model " + model + " --n 3000 --replicate 2 ";
    const std::string word = ramify(what + "--format parens").out;
    std::size_t height = 1, deepest = 1;
    for (const char c : word) {
      height += c == '(' ? 1 : 0;
      deepest = std::max(deepest, height);
      height -= c == ')' ? 1 : 0;
    }
    const std::string whole = line(ramify(what + "--statistics height --no-graft").out, 2);
    EXPECT_EQ(whole.substr(whole.rfind(',') + 1), std::to_string(deepest)) << model;
    const std::string grafted = line(ramify(what + "--statistics strahler,height,nodes").out, 2);
    const std::string grown = line(ramify(what + "--statistics strahler,height,nodes --no-graft").out, 2);
    EXPECT_NE(grafted, grown) << model << ": nothing was grafted";
  }
}

TEST(Sample, TooSmallTreesForGraftsAreGrownWhole) {
  const std::string what =
      "sample --model 'patricia(0.23)' --n 1000 --replicates 9 --statistics strahler,nodes";
  EXPECT_EQ(ramify(what).out, ramify(what + " --no-graft").out);
}

TEST(Sample, ABillionNodesTakeNoTime) {
  const Ran ran = ramify("sample --model bst --n 1e9 --replicates 3 --statistics strahler");
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (std::size_t row = 2; row <= 4; ++row) {
    const std::string text = line(ran.out, row);
    const int order = std::stoi(text.substr(text.rfind(',') + 1));
    EXPECT_TRUE(order == 18 || order == 19) << text;  // log(10^9) / log(3.0438) = 18.6
  }
}

TEST(Sample, StatisticsDoNotDependOnWhatElseIsAskedFor) {
  const Ran lean = ramify("sample --model bst --n 300 --replicates 5 --statistics height");
  const Ran full = ramify("sample --model bst --n 300 --replicates 5 --statistics height,depth");
  for (std::size_t row = 2; row <= 6; ++row) {
    const std::string with_depth = line(full.out, row);
    EXPECT_EQ(line(lean.out, row), with_depth.substr(0, with_depth.rfind(',')));
  }
}

TEST(Sample, AnExternalNodeAloneIsATree) {
  const Ran ran = ramify(
      "sample --model catalan --n 0 --statistics "
      "size,strahler,height,depth,nodes,streams,streams_mean_ratio");
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(line(ran.out, 2), "catalan,0,1996,0,0,0,1,0,1,1,");
  EXPECT_EQ(ramify("sample --model catalan --n 0 --format parens").out, "E\n");
}

TEST(Sample, ThreadsAndOutputFileChangeNothing) {
  const Scratch scratch;
  const std::string what =
      "sample --model 'patricia(0.23)' --n 200 --replicates 50 --statistics strahler,nodes";
  const std::string expected = ramify(what + " --threads 1").out;
  EXPECT_EQ(expected, ramify(what + " --threads 7").out);
  EXPECT_EQ(ramify(what + " -o " + (scratch / "t.csv").string()).out, "");
  EXPECT_EQ(expected, read_file(scratch / "t.csv"));
}

TEST(Sample, AStatisticIsNamedAsEverywhere) {
  EXPECT_EQ(ramify("sample --model bst --n 9 --statistic height").out,
            ramify("sample --model bst --n 9 --statistics height").out);
  EXPECT_EQ(ramify("law --model bst --n 9 --statistic height").out,
            ramify("law --model bst --n 9 --statistics height").out);
}

/// docs/coverage.md: it says nothing of nodes with three children.
TEST(Sample, TheCollessIndexOfTreesWithForksOfThreeIsEmpty) {
  EXPECT_EQ(line(ramify("sample --model 'ternary(0.3)' --n 5 --statistics size,colless").out, 2),
            "ternary(0.3),5,1996,0,5,");
  EXPECT_EQ(line(ramify("sample --model chain --n 5 --statistics size,colless").out, 2),
            "chain,5,1996,0,5,10");
}

TEST(Sample, ModelsWithParametersAreQuoted) {
  EXPECT_EQ(ramify("sample --model 'beta(1,5)' --n 1").out,
            "model,n,seed,replicate,strahler,height\n\"beta(1,5)\",1,1996,0,1,2\n");
}

}  // namespace
}  // namespace ramify::test
