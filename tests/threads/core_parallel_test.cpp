#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "ramify/core/parallel.hpp"

namespace ramify {
namespace {

// Every item waits for all the others: fewer threads than items would not meet. The minute is for failures.
TEST(ParallelFor, RunsAsManyThreadsAsAreAskedForHoweverFewTheCores) {
  constexpr unsigned threads = 7;
  std::mutex mutex;
  std::condition_variable met;
  std::set<unsigned> workers;
  parallel_for(threads, threads, [&](std::size_t, unsigned worker) {
    std::unique_lock lock(mutex);
    workers.insert(worker);
    met.notify_all();
    EXPECT_TRUE(met.wait_for(lock, std::chrono::minutes(1), [&] { return workers.size() == threads; }));
  });
  EXPECT_EQ(workers.size(), threads);
}

TEST(ParallelFor, ThrowsWhatAnItemThrew) {
  const auto fails = [](std::size_t item, unsigned) {
    if (item == 3) throw std::runtime_error("third");
  };
  EXPECT_THROW(parallel_for(100, 2, fails), std::runtime_error);
}

}  // namespace
}  // namespace ramify
