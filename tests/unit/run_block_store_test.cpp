// What a run keeps: block by block, of one plan, and nothing of what is not its own.
#include <filesystem>
#include <fstream>
#include <string>

#include "support/error_of.hpp"
#include "support/scratch.hpp"
#include "support/uninterrupted.hpp"
#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/run/block_store.hpp"
#include "ramify/run/runner.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

Plan plan_of(const std::string& lines) {
  return make_plan(
      parse_run_config("models = [\"bst\"]\nn = [100, 4000]\nstatistics = [\"strahler\", \"streams\", "
                       "\"streams_mean_ratio\"]\n" +
                           lines,
                       "store.toml"));
}

class Store : public testing::Test {
 protected:
  static bool run(BlockStore& store, const Plan& plan, std::vector<CellResult>* cells = nullptr) {
    RunObserver observer;
    observer.cell_done = [&](std::size_t, const CellResult& cell) {
      if (cells != nullptr) cells->push_back(cell);
    };
    return run_cells(plan, store, 1, test::uninterrupted, observer);
  }

  const Plan plan_ = plan_of("replicates = 3000\n");
  const test::Scratch scratch_;
  const fs::path file_ = scratch_ / BlockStore::file_name;
};

TEST_F(Store, KeepsEveryBlockAndThenTheSumOfACell) {
  const GrownBlock block{{1, 0, 200, 0}, CellAccumulator(plan_.statistics, 11).sums()};
  {
    BlockStore store(file_, plan_);
    EXPECT_TRUE(store.kept().none());
    store.save(block);
    store.save({{1, 200, 400, 1}, block.sums});
    EXPECT_EQ(store.kept().blocks, 2u);
  }
  BlockStore store(file_, plan_);
  EXPECT_FALSE(store.set_aside());
  ASSERT_EQ(store.blocks(1).size(), 2u);
  EXPECT_EQ(store.blocks(1).front().block, block.block);
  EXPECT_EQ(store.blocks(1).front().sums, block.sums);
  EXPECT_TRUE(store.blocks(0).empty());
  store.complete(1, block.sums);
  EXPECT_EQ(to_string(store.kept()), "1 cell and 0 blocks");
  EXPECT_EQ(store.cell(1), block.sums);
  EXPECT_EQ(store.cell(0), std::nullopt);
}

TEST_F(Store, OfAFinishedRunGivesItsCellsBackToTheLastBit) {
  std::vector<CellResult> grown, loaded;
  {
    BlockStore store(file_, plan_);
    EXPECT_TRUE(run(store, plan_, &grown));
  }
  BlockStore store(file_, plan_);
  EXPECT_EQ(to_string(store.kept()), "2 cells and 0 blocks");
  EXPECT_TRUE(run(store, plan_, &loaded));
  ASSERT_EQ(loaded.size(), grown.size());
  for (std::size_t c = 0; c < grown.size(); ++c)
    for (std::size_t i = 0; i < grown[c].columns.size(); ++i) {
      EXPECT_EQ(loaded[c].columns[i].mean, grown[c].columns[i].mean);
      EXPECT_EQ(loaded[c].columns[i].variance, grown[c].columns[i].variance);
      EXPECT_EQ(loaded[c].columns[i].q95, grown[c].columns[i].q95);
    }
}

TEST_F(Store, OfAnotherPlanIsRefusedWithTheFirstDifference) {
  {
    BlockStore store(file_, plan_);
  }
  const auto refused = [&](const Plan& plan) {
    return test::error_of([&] { BlockStore store(file_, plan); });
  };
  EXPECT_NE(refused(plan_of("replicates = 3000\nseed = 7\n"))
                .find("it has \"seed 1996\" where this one has \"seed 7\""),
            std::string::npos);
  EXPECT_NE(refused(plan_of("replicates = 3001\n")).find("bst at n = 100: 3000 trees"), std::string::npos);
  Plan shorter = plan_;
  shorter.cells.pop_back();
  EXPECT_NE(refused(shorter).find("where this one has \"nothing more\""), std::string::npos);
  EXPECT_TRUE(refused(plan_).empty());
}

TEST_F(Store, WhatIsNoneIsSetAsideUnchanged) {
  const std::string mine = "my thesis, which happens to have that name\n" + std::string(5000, 'x');
  for (const char* name : {"blocks.sqlite.damaged", "blocks.sqlite.damaged-2"}) {
    std::ofstream(file_) << mine;
    {
      BlockStore store(file_, plan_);
      ASSERT_TRUE(store.set_aside());
      EXPECT_EQ(store.set_aside()->filename(), name);
      EXPECT_EQ(read_text_file(*store.set_aside()), mine);
      EXPECT_TRUE(store.kept().none());
    }
    fs::remove(file_);
  }
}

TEST_F(Store, DamagedInTheMiddleIsSetAside) {
  {
    BlockStore store(file_, plan_);
    for (std::size_t i = 0; i < 200; ++i)
      store.save({{1, i, i + 1, i}, CellAccumulator(plan_.statistics, 11).sums()});
  }
  ASSERT_GT(fs::file_size(file_), 40'000u);
  std::fstream damaged(file_, std::ios::in | std::ios::out | std::ios::binary);
  damaged.seekp(8192);
  damaged << std::string(16'384, '\xff');
  damaged.close();
  EXPECT_TRUE(BlockStore(file_, plan_).set_aside());
}

TEST_F(Store, IsForOneProgramAtATime) {
  BlockStore store(file_, plan_);
  store.save({{1, 0, 200, 0}, CellAccumulator(plan_.statistics, 11).sums()});
  EXPECT_NE(test::error_of([&] { BlockStore second(file_, plan_); }).find("another program uses"),
            std::string::npos);
  EXPECT_EQ(store.kept().blocks, 1u);
}

TEST_F(Store, WhereNothingCanBeWrittenSaysWhatToDo) {
  const fs::path nowhere = scratch_ / "none" / BlockStore::file_name;
  EXPECT_NE(test::error_of([&] { BlockStore store(nowhere, plan_); }).find("cannot write"),
            std::string::npos);
}

TEST_F(Store, HasNothingOfAFileThatIsNone) {
  EXPECT_TRUE(BlockStore::kept_in(scratch_ / "nothing").none());
  std::ofstream(file_) << "text";
  EXPECT_TRUE(BlockStore::kept_in(file_).none());
}

}  // namespace
}  // namespace ramify
