// The loop that grows trees: each once, the same whatever the threads and the blocks.
#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <set>

#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/grow_blocks.hpp"

namespace ramify {
namespace {

constexpr SamplingMethod grafted{orders_and_height, true};

GrowingJob job(const char* model, Size n, std::uint64_t first, std::uint64_t last,
               std::uint64_t most = 1024) {
  return {Model::parse(model), n, test::seed_of("grow blocks"), grafted, first, last, most};
}

/// Nodes of order 0 and 1 of every tree, by job and replicate; fails where a tree is seen twice.
using Seen = std::map<std::pair<std::size_t, std::uint64_t>, std::pair<std::uint64_t, std::uint64_t>>;

Seen grow(const std::vector<GrowingJob>& jobs, unsigned threads) {
  Seen seen;
  std::mutex mutex;
  const Cancellation never;
  grow_blocks(jobs, threads, never, [&](const Block& block, const BlockTrees& trees) {
    std::uint64_t expected = block.first;
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      EXPECT_EQ(replicate, expected++);
      const std::lock_guard lock(mutex);
      EXPECT_TRUE(seen.try_emplace({block.job, replicate}, measures.nodes[0], measures.nodes[1]).second);
    });
    EXPECT_EQ(expected, block.last);
  });
  return seen;
}

TEST(GrowBlocks, BlocksCoverAJobOnceInOrder) {
  for (const auto& wanted :
       {job("bst", 10, 0, 5000), job("bst", 100'000, 7, 30), job("chain", 1u << 22, 0, 3),
        job("bst", 10, 0, 100, 16), job("bst", 10, 4, 4)}) {
    std::uint64_t next = wanted.first;
    const auto blocks = blocks_of(wanted, 3);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      EXPECT_EQ(blocks[i].job, 3u);
      EXPECT_EQ(blocks[i].index, i);
      EXPECT_EQ(blocks[i].first, next);
      EXPECT_GT(blocks[i].last, next);
      EXPECT_LE(blocks[i].trees(), wanted.most_trees);
      next = blocks[i].last;
    }
    EXPECT_EQ(next, wanted.last);
  }
}

TEST(GrowBlocks, ABlockIsAboutAMillionNodes) {
  EXPECT_EQ(blocks_of(job("bst", 1000, 0, 2096), 0).size(), 3u);  // too small to be grafted: 1024, 1024, 48
  EXPECT_EQ(blocks_of(job("catalan", 1023, 0, 10), 0).size(), 1u);
  GrowingJob whole = job("bst", 1u << 19, 0, 10);
  whole.method.graft = false;
  EXPECT_EQ(blocks_of(whole, 0).size(), 5u);
}

TEST(GrowBlocks, EveryTreeOnceWhateverTheThreadsAndBlocks) {
  std::vector<GrowingJob> jobs{job("bst", 2000, 0, 40, 7), job("patricia(0.23)", 50, 10, 25, 4),
                               job("bst", 9, 3, 3), job("bst", 30, 0, 20, 20), job("trie(0.5)", 20, 0, 9, 2)};
  const Seen one = grow(jobs, 1);
  EXPECT_EQ(one.size(), 40u + 15 + 20 + 9);
  EXPECT_EQ(grow(jobs, 3), one);
  for (GrowingJob& coarse : jobs) coarse.most_trees = 1000;
  EXPECT_EQ(grow(jobs, 7), one);
}

// Two sizes of a model share what is grafted, which is computed for the larger: alone they are the same.
TEST(GrowBlocks, ATreeDoesNotDependOnTheOtherJobs) {
  const Seen both = grow({job("bst", 1500, 0, 5), job("bst", 100'000, 0, 5)}, 2);
  const Seen small = grow({job("bst", 1500, 0, 5)}, 1);
  for (const auto& [place, nodes] : small) EXPECT_EQ(both.at(place), nodes);
  const Seen late = grow({job("bst", 1500, 3, 5)}, 1);
  for (const auto& [place, nodes] : late) EXPECT_EQ(both.at(place), nodes);
}

TEST(GrowBlocks, StopsBetweenTrees) {
  Cancellation cancellation;
  std::atomic<std::uint64_t> trees = 0;
  const auto grow_two = [&](const Block&, const BlockTrees& block) {
    block.each([&](std::uint64_t, const TreeMeasures&) {
      if (++trees == 2) cancellation.request();
    });
  };
  EXPECT_THROW(grow_blocks({job("bst", 10, 0, 1000)}, 1, cancellation, grow_two), Interrupted);
  EXPECT_EQ(trees, 2u);
}

TEST(GrowBlocks, HandsOnWhatTheWorkThrows) {
  const Cancellation never;
  const auto refuse = [](const Block&, const BlockTrees&) { throw Error("full", "the disk", "free space"); };
  EXPECT_THROW(grow_blocks({job("bst", 10, 0, 10)}, 2, never, refuse), Error);
}

}  // namespace
}  // namespace ramify
