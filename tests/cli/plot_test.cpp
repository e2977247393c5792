// --plot: a picture beside the table, by gnuplot; without it one clear line and nothing written.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

bool gnuplot_is_there() {
  return shell("command -v gnuplot").code == 0;
}

class Picture : public testing::TestWithParam<std::string> {};

TEST_P(Picture, StandsBesideTheTable) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const Scratch scratch;
  const Ran ran = ramify(GetParam() + " --plot " + (scratch / "a.svg").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, ramify(GetParam()).out);
  EXPECT_NE(read_file(scratch / "a.svg").find("</svg>"), std::string::npos);
  EXPECT_EQ(ramify(GetParam() + " --plot " + (scratch / "a.png").string()).code, 0);
  EXPECT_TRUE(read_file(scratch / "a.png").starts_with("\x89PNG"));
}

INSTANTIATE_TEST_SUITE_P(All, Picture,
                         testing::Values("law --model bst --n 20 --statistic height",
                                         "law --model bst --n 20,100 --statistic orders",
                                         "sample --model bst --n 50 --replicates 40 --statistics height",
                                         "design --map --depth 1.6,2,3",
                                         "measure data/examples/sapling.newick",
                                         "measure data/examples/sapling.newick --leaf-order 0"));

TEST(Plot, IsRefusedInOneLineAndNothingIsWritten) {
  const Scratch scratch;
  for (const char* command :
       {"law --model bst --n 20 --statistic height --moments --plot a.svg",
        "law --model bst --n 20 --statistic height --plot a.pdf", "sample --model bst --n 20 --plot a.svg",
        "sample --model bst --n 20 --format newick --plot a.svg",
        "measure data/examples/sapling.newick --plot /nowhere/a.svg"}) {
    const Ran ran = ramify(command);
    EXPECT_EQ(ran.code, 2) << command;
    EXPECT_EQ(ran.out, "") << command;
    EXPECT_EQ(count_lines(ran.err), 1u) << command << '\n' << ran.err;
  }
}

TEST(Plot, WithoutGnuplotIsSaid) {
  const Scratch scratch;
  const std::string picture = (scratch / "a.svg").string();
  const Ran ran = shell("PATH=" + scratch.path().string() + " " + RAMIFY_PROGRAM +
                        " law --model bst --n 20 --statistic height --plot " + picture);
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "ramify: --plot " + picture +
                         " (gnuplot is not installed): install gnuplot, or leave --plot out\n");
}

}  // namespace
}  // namespace ramify::test
