// Every verb explains itself with an example that works.
#include <set>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// The verbs that the program says it has.
std::vector<std::string> verbs() {
  const std::string help = ramify("--help").out;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  std::vector<std::string> names;
  while (std::getline(lines, line) && line.starts_with("  ")) {
    std::istringstream words(line);
    if (std::string name; line[2] != ' ' && words >> name) names.push_back(name);
  }
  return names;
}

/// The command behind "Example: ramify" in the help of a verb.
std::string example_of(const std::string& verb) {
  const std::string help = ramify(verb + " --help").out, mark = "Example: ramify ";
  const auto begin = help.find(mark);
  if (begin == std::string::npos) return "";
  const auto end = help.find('\n', begin);
  return help.substr(begin + mark.size(), end - begin - mark.size());
}

TEST(Help, OfEveryVerbHasAnExample) {
  const auto all = verbs();
  EXPECT_GE(all.size(), 10u);
  for (const auto& verb : all) {
    EXPECT_EQ(ramify(verb + " --help").code, 0);
    EXPECT_TRUE(example_of(verb).starts_with(verb + " ")) << verb;
  }
}

// run and reproduce take minutes, the tree of `test` is the reader's own, and draw writes a file (README.md
// has its example).
TEST(Help, ExamplesOfQuickVerbsRun) {
  const std::set<std::string> long_ones{"run", "reproduce", "fit", "test", "draw"};
  for (const auto& verb : verbs()) {
    if (long_ones.contains(verb)) continue;
    const std::string example = example_of(verb);
    const Ran ran = ramify(example);
    EXPECT_EQ(ran.code, 0) << example << ran.err;
    EXPECT_GT(count_lines(ran.out), 1u) << example;
  }
}

TEST(Describe, CompletesVerbsAndOptionsInBash) {
  const Scratch scratch;
  const std::string file = (scratch / "completion").string();
  ASSERT_EQ(ramify("describe bash -o " + file).code, 0);
  const auto completed = [&](const std::string& words, int place) {
    return shell("bash -c '. " + file + "; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(place) +
                 "; _ramify; echo ${COMPREPLY[*]}'")
        .out;
  };
  EXPECT_EQ(completed("ramify sam", 1), "sample\n");
  EXPECT_EQ(completed("ramify measure --tab", 2), "--table\n");
  EXPECT_EQ(completed("ramify law --statis", 2), "--statistic --statistics\n");
}

TEST(Describe, HasEveryVerbAndOption) {
  const std::string man = ramify("describe man").out, zsh = ramify("describe zsh").out;
  for (const auto& verb : verbs()) {
    EXPECT_NE(man.find("\n.SH RAMIFY " + verb + "\n"), std::string::npos) << verb;
    EXPECT_NE(zsh.find("\n    " + verb + ")\n"), std::string::npos) << verb;
  }
  EXPECT_NE(man.find("\\-\\-leaf\\-order VALUE\n"), std::string::npos);
  if (shell("command -v groff").code == 0) {
    const Ran set =
        shell("( " + std::string(RAMIFY_PROGRAM) + " describe man | groff -man -ww -Tutf8 >/dev/null )");
    EXPECT_EQ(set.err, "");
  }
}

/// What zsh is told at this place of a line: its own _describe and _arguments need a terminal, so that these
/// print what they are given.
std::string told_to_zsh(const std::string& file, const std::string& words, int place) {
  return shell(
             "zsh -fc '_describe() { print -l -- \"${(@P)2}\" }; _arguments() { print -l -- \"$@\" }; "
             "complete_word() { local -a words=(" +
             words + "); local -i CURRENT=" + std::to_string(place) + "; . " + file + " }; complete_word'")
      .out;
}

TEST(Describe, CompletesVerbsAndOptionsInZsh) {
  if (shell("command -v zsh").code != 0) GTEST_SKIP() << "zsh is not installed";
  const Scratch scratch;
  const std::string file = (scratch / "_ramify").string();
  ASSERT_EQ(ramify("describe zsh -o " + file).code, 0);
  EXPECT_EQ(shell("zsh -n " + file).code, 0);
  const std::string names = told_to_zsh(file, "ramify sam", 2);
  for (const auto& verb : verbs())
    EXPECT_NE(("\n" + names).find("\n" + verb + ":"), std::string::npos) << verb;
  const std::string options = told_to_zsh(file, "ramify measure --tab", 3);
  EXPECT_NE(options.find("*--table["), std::string::npos) << options;
  EXPECT_EQ(options.find("*--replicates["), std::string::npos) << "of another verb: " << options;
}

TEST(Help, VersionIsSaid) {
  EXPECT_EQ(ramify("-V").out, ramify("--version").out);
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
