// The numbers themselves: summaries of every model and every statistic that were committed once. A difference
// means that trees of the same seed have changed; say so in CHANGELOG.md and renew the files: scripts/golden
#include <regex>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(RAMIFY_SOURCE) / "tests/golden";

/// A config of the folder and the summary that it must give.
struct Golden {
  const char* config;
  const char* summary;

  friend std::ostream& operator<<(std::ostream& out, const Golden& golden) { return out << golden.config; }
};

class GoldenRun : public testing::TestWithParam<Golden> {};

TEST_P(GoldenRun, GivesTheCommittedSummary) {
  const Scratch scratch;
  const std::string config = GetParam().config;
  const Ran ran = ramify("run tests/golden/" + config + ".toml --out " + scratch.path().string());
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string golden = read_file(folder / GetParam().summary);
  EXPECT_GT(golden.size(), 10'000u);
  EXPECT_EQ(read_file(scratch / config / "summary.csv"), golden);
}

INSTANTIATE_TEST_SUITE_P(Committed, GoldenRun,
                         testing::Values(Golden{"small", "summary.csv"}, Golden{"models", "models.csv"},
                                         Golden{"statistics", "statistics.csv"}),
                         [](const auto& instance) { return std::string(instance.param.config); });

/// The names in the first column of what `ramify list` prints: "beta" of "beta(a,b)".
std::vector<std::string> listed(const std::string& what) {
  std::vector<std::string> names;
  std::istringstream lines(ramify("list " + what).out);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::smatch name;
    if (std::regex_search(line, name, std::regex("[a-z][a-z0-9_]*"))) names.push_back(name[0]);
  }
  return names;
}

TEST(Golden, EveryModelIsInAConfig) {
  const std::string config = read_file(folder / "models.toml");
  const auto models = listed("models");
  EXPECT_GE(models.size(), 25u);
  for (const auto& name : models)
    EXPECT_TRUE(std::regex_search(config, std::regex("\"" + name + "[\"(]")))
        << name << ": give it a line in tests/golden/models.toml and run scripts/golden";
}

TEST(Golden, EveryStatisticIsInAConfig) {
  const std::string config = read_file(folder / "statistics.toml");
  const auto statistics = listed("statistics");
  EXPECT_GE(statistics.size(), 31u);
  for (const auto& name : statistics)
    EXPECT_NE(config.find("\"" + name + "\""), std::string::npos)
        << name << ": give it a line in tests/golden/statistics.toml and run scripts/golden";
}

}  // namespace
}  // namespace ramify::test
