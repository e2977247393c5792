// A run on more threads than cores: the committed bytes, whatever the order in which its blocks end.
#include <filesystem>
#include <string>
#include <vector>

#include "support/sanitized.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "ramify/run/run.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

TEST(RunThreads, OfAnyNumberGiveTheCommittedSummary) {
  const std::filesystem::path golden = RAMIFY_SOURCE_DIR "/tests/golden";
  const RunConfig config = read_run_config(golden / "small.toml");
  const test::Scratch scratch;
  const Cancellation never;
  for (const unsigned threads : test::sanitized ? std::vector{7u} : std::vector{1u, 7u}) {
    const std::filesystem::path folder = scratch / std::to_string(threads);
    run_experiment(config, {folder, threads, KeptCells::refuse, {}}, never);
    EXPECT_EQ(read_text_file(folder / "summary.csv"), read_text_file(golden / "summary.csv"))
        << threads << " threads";
  }
}

}  // namespace
}  // namespace ramify
