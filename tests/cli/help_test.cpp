// Every verb explains itself with an example that works.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

class Verb : public testing::TestWithParam<const char*> {};

TEST_P(Verb, HasHelpWithAnExample) {
  const Ran ran = ramify(std::string(GetParam()) + " --help");
  EXPECT_EQ(ran.code, 0);
  EXPECT_NE(ran.out.find("Example: ramify " + std::string(GetParam())), std::string::npos) << ran.out;
}

INSTANTIATE_TEST_SUITE_P(Verbs, Verb,
                         testing::Values("list", "sample", "law", "measure", "test", "theory", "run",
                                         "reproduce", "fit"));

TEST(Help, ExamplesOfQuickVerbsRun) {
  for (const char* verb : {"list", "sample", "law", "measure", "theory"}) {
    const std::string help = ramify(std::string(verb) + " --help").out;
    const auto begin = help.find("Example: ramify ") + 16;
    const std::string example = help.substr(begin, help.find('\n', begin) - begin);
    const Ran ran = ramify(example);
    EXPECT_EQ(ran.code, 0) << example << ran.err;
    EXPECT_GT(count_lines(ran.out), 1u) << example;
  }
}

TEST(Help, VersionIsSaid) {
  EXPECT_EQ(ramify("--version").out.substr(0, 7), "ramify ");
}

TEST(List, NamesEveryModelWithWhatNCounts) {
  const std::string models = ramify("list models").out;
  for (const char* name : {"bst", "\"beta(a,b)\"", "split(x)", "dst(p)", "patricia(p)", "catalan"})
    EXPECT_NE(models.find(std::string("\n") + name + ",internal nodes"), std::string::npos) << name;
  EXPECT_NE(ramify("list statistics").out.find("streams_0..streams_K"), std::string::npos);
  EXPECT_NE(ramify("list statistics").out.find("exact law,grafted,B6"), std::string::npos);
  EXPECT_NE(ramify("list claims").out.find("C20"), std::string::npos);
}

TEST(Theory, DepthAndHeightOfTheBst) {
  const std::string table = ramify("theory --model bst").out;
  EXPECT_EQ(table.substr(0, table.find('\n')), "model,constant,value,error,formula,source");
  EXPECT_NE(table.find("\nbst,depth,2,"), std::string::npos) << table;
  EXPECT_NE(table.find("\nbst,height,4.311070407001"), std::string::npos) << table;
}

}  // namespace
}  // namespace ramify::test
