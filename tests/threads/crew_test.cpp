// Threads that do items as they are given them, and tell what became of them.
#include "ramify/ranks/crew.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr std::chrono::seconds patience{60};  // for failures

TEST(Crew, TellsTheOutcomeOfEveryItem) {
  Crew crew(3, [](std::size_t item, unsigned) { return Bytes(item % 5); });
  for (std::size_t item = 0; item < 200; ++item) crew.give(item);
  std::set<std::size_t> done;
  while (done.size() < 200)
    for (const Outcome& outcome : crew.outcomes(patience)) {
      EXPECT_EQ(outcome.bytes.size(), outcome.item % 5);
      EXPECT_TRUE(done.insert(outcome.item).second) << outcome.item;
    }
  EXPECT_TRUE(crew.outcomes(std::chrono::microseconds(1)).empty());
}

TEST(Crew, ThrowsWhatAnItemThrewAndBeginsNoOther) {
  std::atomic<int> begun = 0;
  Crew crew(1, [&begun](std::size_t, unsigned) -> Bytes {
    ++begun;
    throw std::runtime_error("first");
  });
  crew.give(0);
  crew.give(1);
  EXPECT_THROW(crew.outcomes(patience), std::runtime_error);
  EXPECT_EQ(begun, 1);
}

TEST(Crew, EndsWithItemsThatNobodyBegan) {
  std::atomic<bool> let_go = false;
  Crew crew(1, [&let_go](std::size_t, unsigned) {
    while (!let_go) std::this_thread::yield();
    return Bytes{};
  });
  for (std::size_t item = 0; item < 10; ++item) crew.give(item);
  let_go = true;
}

}  // namespace
}  // namespace ramify
