// The numbers themselves: a summary of every model and statistic that was committed once. A difference means
// that trees of the same seed have changed; say so in CHANGELOG.md and renew the file:
//   ramify run tests/golden/small.toml --out DIR && cp DIR/small/summary.csv tests/golden/
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

TEST(Golden, SummaryIsTheCommittedOne) {
  const Scratch scratch;
  const Ran ran = ramify("run tests/golden/small.toml --out " + scratch.path().string());
  ASSERT_EQ(ran.code, 0) << ran.err;
  const std::string golden = read_file(std::string(RAMIFY_SOURCE) + "/tests/golden/summary.csv");
  EXPECT_GT(golden.size(), 10'000u);
  EXPECT_EQ(read_file(scratch / "small/summary.csv"), golden);
}

}  // namespace
}  // namespace ramify::test
