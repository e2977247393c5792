// ramify draw: files that other programs open, the tree of sample, one line for whatever cannot be drawn.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

TEST(Draw, WritesWhatTheNameSays) {
  const Scratch scratch;
  const std::string sapling = "draw --tree data/examples/sapling.newick -o ";
  for (const char* style : {" --style dendrogram", " --style upright"}) {
    ASSERT_EQ(ramify(sapling + (scratch / "a.svg").string() + style).code, 0);
    ASSERT_EQ(ramify(sapling + (scratch / "a.png").string() + style).code, 0);
    EXPECT_NE(read_file(scratch / "a.svg").find("</svg>"), std::string::npos);
    EXPECT_TRUE(read_file(scratch / "a.png").starts_with("\x89PNG"));
  }
}

TEST(Draw, TheSameTreeIsTheSameBytes) {
  const Scratch scratch;
  const std::string bst = "draw --model bst --n 100 --seed 7 --replicate 3 -o ";
  ASSERT_EQ(ramify(bst + (scratch / "a.svg").string()).code, 0);
  ASSERT_EQ(ramify(bst + (scratch / "b.svg").string()).code, 0);
  EXPECT_EQ(read_file(scratch / "a.svg"), read_file(scratch / "b.svg"));
}

// The tree that sample writes, read back, is the tree that draw grows: but for the title the drawings are
// one.
TEST(Draw, GrowsTheTreeOfSample) {
  const Scratch scratch;
  const std::string which = "--model 'beta(2,3)' --n 60 --seed 5 --replicate 2 ";
  ASSERT_EQ(ramify("draw " + which + "--same-lengths -o " + (scratch / "a.svg").string()).code, 0);
  const std::string file = scratch.file("t.txt", ramify("sample " + which + "--format parens").out);
  ASSERT_EQ(ramify("draw --same-lengths --tree " + file + " -o " + (scratch / "b.svg").string()).code, 0);
  const auto branches = [](const std::string& svg) {
    std::string paths;
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);)
      if (line.find("stroke-width") != std::string::npos) paths += line + '\n';
    return paths;
  };
  EXPECT_GT(branches(read_file(scratch / "a.svg")).size(), 1000u);
  EXPECT_EQ(branches(read_file(scratch / "a.svg")), branches(read_file(scratch / "b.svg")));
}

struct Refusal {
  std::string arguments, message;
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, InOneLineWithoutAFile) {
  const Scratch scratch;
  scratch.file("two.nwk", "(a,b);\n(c,d);\n");
  scratch.file("nan.nwk", "(a:1,b);\n");
  scratch.file("negative.nwk", "(a:1,b:-2);\n");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(scratch.path()),
                         std::filesystem::directory_iterator());
  };
  const auto before = files();
  const Ran ran =
      shell("cd " + scratch.path().string() + " && " + RAMIFY_PROGRAM + " draw " + GetParam().arguments);
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find(GetParam().message), std::string::npos) << ran.err;
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    All, Refused,
    testing::Values(Refusal{"--model bst --n 10 -o a.pdf", "take a name that ends in .svg or .png"},
                    Refusal{"--model bst --n 10 -o a", "take a name that ends in .svg or .png"},
                    Refusal{"--model bst --n 10", "--output is required"},
                    Refusal{"-o a.svg", "neither --tree nor --model"},
                    Refusal{"--tree two.nwk --model bst --n 3 -o a.svg", "--tree and --model"},
                    Refusal{"--model bst -o a.svg", "add --n"},
                    Refusal{"--model bst --n 1e6 -o a.svg", "take a name that ends in .png"},
                    Refusal{"--model bst --n 1e9 -o a.svg", "take a smaller tree"},
                    Refusal{"--model bst --n 1e9 -o a.png", "take a smaller tree"},
                    Refusal{"--model bst --n 10 --style star -o a.svg", "take dendrogram or upright"},
                    Refusal{"--model bst --n 10 --leaf-order 2 -o a.svg", "it is 0 or 1"},
                    Refusal{"--tree two.nwk -o a.svg", "add --which K, K from 1 to 2"},
                    Refusal{"--tree two.nwk --which 3 -o a.svg", "take a number from 1 to 2"},
                    Refusal{"--tree negative.nwk -o a.svg", "has the length -2"},
                    Refusal{"--tree none.nwk -o a.svg", "none.nwk"},
                    Refusal{"--model bst --n 10 -o nowhere/a.svg", "create its folder"}),
    [](const auto& refusal) { return name_of({std::to_string(refusal.index)}); });

}  // namespace
}  // namespace ramify::test
