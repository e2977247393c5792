// A run that is killed at any moment goes on where it was: the bytes of one that was not disturbed. A minute:
// a hundred processes, each of some tenths of a second.
#include <filesystem>
#include <random>
#include <string>

#include "program.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

namespace fs = std::filesystem;

const char* const config_of_kills =
    "models = [\"bst\", \"catalan\"]\nn = [1000, 20000]\nreplicates = 4000\n"
    "statistics = [\"strahler\", \"streams\", \"streams_mean_ratio\"]\ngraft = false\n";

struct Killed {
  std::size_t kills;     ///< that hit a running process
  std::string last_err;  ///< of the run that was let through
};

/// Kills and resumes until `wanted` kills have hit, then lets it through.
Killed kill_again_and_again(const std::string& run, unsigned threads, std::size_t wanted) {
  std::mt19937 moments(1996 + threads);
  const std::string command = fmt::format("{} {} --threads {} --resume", RAMIFY_PROGRAM, run, threads);
  Killed killed{0, ""};
  while (killed.kills < wanted) {
    const double delay = 0.02 + 0.2 * static_cast<double>(moments() % 1000) / 1000;
    const Ran ran =
        shell(fmt::format("{} & run=$!; sleep {:.3f}; kill -KILL $run; wait $run", command, delay));
    if (ran.code == 0) break;  // it was faster
    ++killed.kills;
  }
  killed.last_err = shell(command).err;
  return killed;
}

class KilledRun : public testing::TestWithParam<unsigned> {};

TEST_P(KilledRun, GoesOnToTheSameBytes) {
  const Scratch scratch;
  const std::string config = scratch.file("killed.toml", config_of_kills);
  ASSERT_EQ(ramify("run " + config + " --out " + (scratch / "calm").string()).code, 0);
  constexpr std::size_t wanted = 34;
  std::size_t kills = 0;
  for (int round = 0; kills < wanted && round < 20; ++round) {
    const fs::path out = scratch / fmt::format("killed_{}", round);
    const Killed killed =
        kill_again_and_again("run " + config + " --out " + out.string(), GetParam(), wanted - kills);
    kills += killed.kills;
    for (const char* table : {"summary.csv", "histograms.csv", "orders.csv"})
      EXPECT_EQ(read_file(out / "killed" / table), read_file(scratch / "calm/killed" / table))
          << table << " after " << killed.kills << " kills: " << killed.last_err;
  }
  EXPECT_EQ(kills, wanted);
}

// A limit on the size of a file stands for a disk that is full.
TEST(RunOnAFullDisk, LosesNothing) {
  const Scratch scratch;
  const std::string config = scratch.file("killed.toml", config_of_kills);
  const std::string run = fmt::format("run {} --out {}", config, (scratch / "o").string());
  const Ran full = shell(fmt::format("trap '' XFSZ; ulimit -f 400; {} {}", RAMIFY_PROGRAM, run));
  EXPECT_EQ(full.code, 2);
  EXPECT_EQ(count_lines(full.err), 1u) << full.err;
  EXPECT_NE(full.err.find("--resume goes on with it"), std::string::npos) << full.err;
  const Ran resumed = ramify(run + " --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("are kept from an earlier run"), std::string::npos) << resumed.err;
  ASSERT_EQ(ramify("run " + config + " --out " + (scratch / "calm").string()).code, 0);
  EXPECT_EQ(read_file(scratch / "o/killed/summary.csv"), read_file(scratch / "calm/killed/summary.csv"));
}

INSTANTIATE_TEST_SUITE_P(Threads, KilledRun, testing::Values(1u, 2u, 7u));

}  // namespace
}  // namespace ramify::test
