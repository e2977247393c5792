// Every command that README.md shows is run, as it stands.
#include <gtest/gtest.h>

#include "program.hpp"

namespace ramify::test {
namespace {

std::vector<std::string> commands(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("    ramify ")) found.push_back(line.substr(11));
  return found;
}

TEST(Readme, EveryCommandOfTheProgramRuns) {
  const auto all = commands(read_file(std::string(RAMIFY_SOURCE) + "/README.md"));
  ASSERT_GE(all.size(), 6u);
  for (const auto& command : all) {
    const Ran ran = ramify(command);
    EXPECT_EQ(ran.code, 0) << command << '\n' << ran.err;
    EXPECT_FALSE(ran.out.empty()) << command;
  }
}

TEST(Readme, TheVerdictTableIsTheReferenceRun) {
  const std::string readme = read_file(std::string(RAMIFY_SOURCE) + "/README.md");
  const std::string table = read_file(std::string(RAMIFY_SOURCE) + "/results/reference/quick/verdicts.txt");
  ASSERT_GT(table.size(), 500u);
  EXPECT_NE(readme.find("<!-- verdicts -->\n```\n" + table + "```\n"), std::string::npos);
}

TEST(Readme, TheScriptsItNamesAreThere) {
  for (const char* script : {"scripts/reproduce", "scripts/test", "scripts/setup"})
    EXPECT_EQ(shell(std::string("test -x ") + script).code, 0) << script;
}

}  // namespace
}  // namespace ramify::test
