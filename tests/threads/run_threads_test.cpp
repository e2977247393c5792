// A run on more threads than cores: the committed bytes, whatever the order in which its blocks end.
#include <filesystem>

#include <gtest/gtest.h>

#include "ramify/run/run.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

TEST(RunThreads, OfAnyNumberGiveTheCommittedSummary) {
  const std::filesystem::path golden = RAMIFY_SOURCE_DIR "/tests/golden";
  const RunConfig config = read_run_config(golden / "small.toml");
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "ramify_run_threads";
  const Cancellation never;
  for (const unsigned threads : {1u, 7u}) {
    std::filesystem::remove_all(folder);
    run_experiment(config, {folder, threads, KeptCells::refuse, {}}, never);
    EXPECT_EQ(read_text_file(folder / "summary.csv"), read_text_file(golden / "summary.csv"))
        << threads << " threads";
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ramify
