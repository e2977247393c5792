// A run that is stopped keeps its complete cells, and resumed gives the bytes of one that was not.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <thread>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "ramify/run/run.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

class StoppedRun : public testing::Test {
 protected:
  /// Runs the config on one thread, whose blocks come in order, and stops once so many nodes are grown.
  RunOutcome run(const char* name, KeptCells kept, double nodes) const {
    Cancellation stop;
    const auto watch = [&](double done, double) {
      if (done >= nodes) stop.request();
    };
    return run_experiment(config_, {folder_ / name, 1, kept, watch}, stop);
  }

  std::string table(const fs::path& run) const { return read_text_file(run / "summary.csv"); }

  const RunConfig config_ = parse_run_config(
      "models = [\"bst\"]\nn = [100, 1000, 30000]\nreplicates = 100\n"
      "statistics = [\"strahler\", \"streams\"]\ngraft = false\n",
      "stopped.toml");
  static constexpr double two_cells = 100 * 100 + 100 * 1000;
  static constexpr double never = 1e300;
  const test::Scratch scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(StoppedRun, KeepsCompleteCellsAndPutsItsThingsAway) {
  const RunOutcome stopped = run("o", KeptCells::refuse, two_cells);
  EXPECT_FALSE(stopped.finished);
  EXPECT_EQ(stopped.folder, folder_ / "o.incomplete");
  EXPECT_FALSE(fs::exists(folder_ / "o"));
  ASSERT_EQ(stopped.checked.cells.size(), 2u);
  EXPECT_EQ(stopped.checked.cells.back().result.n, 1000u);
  const std::string partial = table(stopped.folder);
  EXPECT_NE(partial.find("bst,1000,"), std::string::npos);
  EXPECT_EQ(partial.find("bst,30000,"), std::string::npos);
  EXPECT_NE(read_text_file(stopped.folder / "provenance.json").find("interrupted"), std::string::npos);
}

// Laws and plots take longer than the two seconds that a stopped run has.
TEST_F(StoppedRun, HasNoTimeForLawsAndPlots) {
  const RunOutcome stopped = run("o", KeptCells::refuse, two_cells);
  for (const auto& cell : stopped.checked.cells) EXPECT_FALSE(cell.worst_z());
  EXPECT_TRUE(fs::is_empty(stopped.folder / "plots"));
}

TEST_F(StoppedRun, ResumesToTheSameBytes) {
  run("o", KeptCells::refuse, two_cells);
  EXPECT_THROW(run("o", KeptCells::refuse, never), Error);
  const RunOutcome resumed = run("o", KeptCells::take_over, never),
                   fresh = run("fresh", KeptCells::refuse, never);
  EXPECT_TRUE(resumed.finished);
  EXPECT_EQ(resumed.folder, folder_ / "o");
  EXPECT_EQ(table(resumed.folder), table(fresh.folder));
  EXPECT_NE(table(fresh.folder).find("bst,30000,"), std::string::npos);
}

TEST_F(StoppedRun, IsDroppedWhereThatIsAskedFor) {
  run("o", KeptCells::refuse, two_cells);
  EXPECT_TRUE(run("o", KeptCells::drop, never).finished);
  EXPECT_FALSE(fs::exists(folder_ / "o.incomplete"));
}

TEST_F(StoppedRun, DoesNotReplaceAFolderThatIsNotOfARun) {
  fs::create_directories(folder_ / "mine");
  std::ofstream(folder_ / "mine/thesis.tex") << "x";
  EXPECT_THROW(run("mine", KeptCells::refuse, never), Error);
  std::ofstream(folder_ / "file") << "x";
  EXPECT_THROW(run("file", KeptCells::refuse, never), Error);
  EXPECT_TRUE(fs::exists(folder_ / "mine/thesis.tex") && fs::exists(folder_ / "file"));
}

TEST_F(StoppedRun, HasItsFolderForItself) {
  const WorkFolder other(folder_ / "o", KeptCells::refuse);
  EXPECT_THROW(run("o", KeptCells::refuse, never), Error);
  EXPECT_THROW(run("o", KeptCells::drop, never), Error);
}

// A fifth of a second, of the two that it may take.
TEST_F(StoppedRun, MayStillBeEndingWhenItIsTakenOver) {
  auto ending = std::make_unique<WorkFolder>(folder_ / "o", KeptCells::refuse);
  const std::jthread end([&ending] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ending.reset();
  });
  EXPECT_TRUE(run("o", KeptCells::take_over, never).finished);
}

}  // namespace
}  // namespace ramify
