// Several processes that work together (docs/cluster.md), started by Open MPI's mpirun on this machine. Each
// start takes a second.
#include <string>
#include <utility>

#include "program.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// Not bound to cores: a test may ask for more threads than there are. --quiet: without mpirun's own words on
/// a process that failed. --foreground: else a signal reaches mpirun twice, and at the second it ends before
/// its ranks do.
const std::string mpirun =
    mpi_as_root + "timeout --foreground 120 mpirun --quiet --oversubscribe --bind-to none";

Ran team(unsigned ranks, const std::string& arguments) {
  return shell(fmt::format("{} -n {} {} {}", mpirun, ranks, RAMIFY_PROGRAM, arguments));
}

/// Two commands in one job: what rank 0 is given, and what rank 1.
Ran pair_of(const std::string& first, const std::string& second) {
  return shell(fmt::format("{} -n 1 {} : -n 1 {}", mpirun, first, second));
}

std::string config_of(std::uint64_t replicates) {
  return fmt::format(
      "models = [\"bst\", \"catalan\"]\nn = [1000, 20000]\nreplicates = {}\n"
      "statistics = [\"strahler\", \"streams\", \"streams_mean_ratio\"]\ngraft = false\n",
      replicates);
}

void expect_same_tables(const std::filesystem::path& one, const std::filesystem::path& other) {
  for (const char* table : {"summary.csv", "histograms.csv", "orders.csv", "report.html"})
    EXPECT_EQ(read_file(one / table), read_file(other / table)) << table;
}

#ifdef RAMIFY_HAS_MPI

class TeamOfRanks : public testing::TestWithParam<unsigned> {};

// Three starts of up to seven processes on two cores: ten seconds.
TEST_P(TeamOfRanks, GivesTheBytesOfOneProcess) {
  const Scratch scratch;
  const std::string run = "run " + scratch.file("c.toml", config_of(600)) + " --out ";
  ASSERT_EQ(ramify(run + (scratch / "alone").string()).code, 0);
  for (const unsigned threads : {1u, 2u, 3u}) {
    const auto out = scratch / fmt::format("together_{}", threads);
    const Ran ran = team(GetParam(), fmt::format("{}{} --threads {}", run, out.string(), threads));
    ASSERT_EQ(ran.code, 0) << ran.err;
    expect_same_tables(scratch / "alone/c", out / "c");
    EXPECT_TRUE(holds(read_file(out / "c/provenance.json"), fmt::format("\"processes\": {}", GetParam())));
  }
}

INSTANTIATE_TEST_SUITE_P(Ranks, TeamOfRanks, testing::Values(2u, 4u, 7u));

// A second for a start, and the fits themselves.
TEST(TeamOfThree, FitsWithTheBootstrapOfOneProcess) {
  for (const char* fit : {"data/walnut.csv --model patricia,bst,aldous --bootstrap 60",
                          "data/sapling_orders_that_meet.csv --bootstrap 60"}) {
    const Ran alone = ramify(fmt::format("fit {}", fit)),
              together = team(3, fmt::format("fit {} --threads 2", fit));
    EXPECT_EQ(together.code, alone.code) << together.err;
    EXPECT_EQ(together.out, alone.out) << fit;
    EXPECT_GT(count_lines(alone.out), 1u);
  }
}

TEST(TeamOfTwo, ReproducesAClaim) {
  const Scratch scratch;
  const auto reproduce = [&](const char* out) {
    return fmt::format("reproduce --claim C4 --out {}", (scratch / out).string());
  };
  const Ran alone = ramify(reproduce("alone")), together = team(2, reproduce("together"));
  EXPECT_EQ(together.code, alone.code) << together.err;
  EXPECT_EQ(together.out, alone.out);
  EXPECT_EQ(read_file(scratch / "alone/verdicts.csv"), read_file(scratch / "together/verdicts.csv"));
}

/// Long enough to be broken off: several seconds of two cores.
constexpr std::uint64_t many = 4000;

/// A shell line that starts rank 0 and, as another command whose number is written down, rank 1; when the
/// store has blocks it does this.
Ran broken_off(const Scratch& scratch, const std::string& run, const std::string& what) {
  const std::string helper = scratch.file(
      "helper.sh",
      fmt::format("echo $$ > {0}\nexec {1} {2}\n", (scratch / "pid").string(), RAMIFY_PROGRAM, run));
  return shell(fmt::format(
      "{0} -n 1 {1} {2} : -n 1 sh {3} & job=$!; for i in $(seq 200); do sleep 0.1; "
      "test -s {4} && test $(stat -c %s {4}) -gt 100000 && break; done; {5}; wait $job",
      mpirun, RAMIFY_PROGRAM, run, helper, (scratch / "o/c.incomplete/blocks.sqlite-wal").string(),
      fmt::vformat(what, fmt::make_format_args((scratch / "pid").string()))));
}

class BrokenTeam : public testing::TestWithParam<std::pair<std::string, std::string>> {};

// Growing for some seconds, twice.
TEST_P(BrokenTeam, LeavesWhatOneProcessGoesOnWith) {
  const Scratch scratch;
  const std::string run = fmt::format("run {} --threads 1 --out ", scratch.file("c.toml", config_of(many)));
  const Ran broken = broken_off(scratch, run + (scratch / "o").string(), GetParam().second);
  EXPECT_NE(broken.code, 0) << broken.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "o/c")) << "it was over before it was broken off";
  const Ran resumed = ramify(run + (scratch / "o").string() + " --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_TRUE(holds(resumed.err, "are kept from an earlier run")) << resumed.err;
  ASSERT_EQ(ramify(run + (scratch / "calm").string()).code, 0);
  expect_same_tables(scratch / "calm/c", scratch / "o/c");
}

INSTANTIATE_TEST_SUITE_P(How, BrokenTeam,
                         testing::Values(std::pair("ByDeathOfARank", "kill -KILL $(cat {})"),
                                         std::pair("ByTermOfARank", "kill -TERM $(cat {})"),
                                         std::pair("ByTermOfTheJob", "kill -TERM $job")),
                         [](const auto& how) { return how.param.first; });

// Seconds until the disk is full, and a start.
TEST(TeamOfTwo, LosesNothingOnAFullDisk) {
  const Scratch scratch;
  const std::string run = fmt::format("run {} --threads 1 --out {}", scratch.file("c.toml", config_of(many)),
                                      (scratch / "o").string());
  const std::string limited = scratch.file(
      "limited.sh", fmt::format("trap '' XFSZ\nulimit -f 400\nexec {} {}\n", RAMIFY_PROGRAM, run));
  const Ran full = pair_of("sh " + limited, fmt::format("{} {}", RAMIFY_PROGRAM, run));
  EXPECT_EQ(full.code, 2) << full.err;
  EXPECT_TRUE(holds(full.err, "--resume goes on with it")) << full.err;
  const Ran resumed = team(2, run + " --resume");
  EXPECT_EQ(resumed.code, 0) << resumed.err;
}

struct Refusal {
  const char* name;
  std::string first, second;  // commands of rank 0 and of rank 1
  const char* message;
};

// A second for each start.
TEST(TeamOfTwo, IsRefusedInOneLineBeforeAnyWork) {
  const Scratch scratch;
  const std::string out = " --out " + (scratch / "o").string();
  const std::string one = "run " + scratch.file("one.toml", config_of(600)) + out,
                    two = "run " + scratch.file("two.toml", config_of(601)) + out;
  const std::string program = RAMIFY_PROGRAM, other = (scratch / "other").string();
  ASSERT_EQ(shell(fmt::format("cp {0} {1} && echo >> {1}", program, other)).code, 0);
  const std::string a_file = scratch.file("file", "");
  const std::vector<Refusal> refusals{
      {"config", program + " " + one, program + " " + two, "rank 1 has another config, data or command"},
      {"build", program + " " + one, other + " " + one, "rank 1 runs another build of ramify"},
      {"reader", program + " " + one, program + " run none.toml",
       "rank 1 cannot go on (cannot read 'none.toml'"},
      {"verb", program + " " + one, program + " list models", "rank 1 has ended before the others"},
      {"folder", program + " run " + (scratch / "one.toml").string() + " --out " + a_file,
       program + " run " + (scratch / "one.toml").string() + " --out " + a_file, "choose another"}};
  for (const auto& [name, first, second, message] : refusals) {
    const Ran ran = pair_of(first, second);
    EXPECT_EQ(ran.code, 2) << name << ": " << ran.err;
    EXPECT_EQ(count_lines(ran.err), 1u) << name << ": " << ran.err;
    EXPECT_TRUE(holds(ran.err, message)) << name << ": " << ran.err;
    EXPECT_EQ(ran.out, "") << name;
  }
}

TEST(TeamOfTwo, LeavesOtherVerbsToOneProcess) {
  const Ran alone = ramify("list models"), together = team(2, "list models");
  EXPECT_EQ(together.code, 0);
  EXPECT_EQ(together.out, alone.out);
  EXPECT_EQ(together.err, "ramify: note: list works in one process: the other 1 of this job wait for it\n");
  const Ran wrong = team(2, "law --model nix --n 5");
  EXPECT_EQ(wrong.code, ramify("law --model nix --n 5").code);
}

#else

TEST(TeamOfTwo, IsRefusedByABuildWithoutMpi) {
  const Ran ran = shell(fmt::format("PMI_SIZE=2 {} list models", RAMIFY_PROGRAM));
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(holds(ran.err, "was built without MPI")) << ran.err;
}

#endif

}  // namespace
}  // namespace ramify::test
