// A block travels: encoded, decoded and merged in its place it gives the cell of an undivided run.
#include <string>

#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "ramify/io/csv_writer.hpp"
#include "ramify/run/exact_check.hpp"
#include "ramify/run/grown_block.hpp"
#include "ramify/run/runner.hpp"

namespace ramify {
namespace {

Plan small_plan() {
  const std::vector<std::string> names{"strahler", "height", "nodes", "streams", "streams_mean_ratio"};
  const auto statistics = StatisticSet::parse(names);
  return {1996,
          statistics,
          sampling_method(statistics, true),
          {{Model::parse("bst"), 200, 300}, {Model::parse("dst(0.3)"), 31, 40}}};
}

GrowingJob job_of(const Plan& plan, std::size_t cell) {
  return {
      plan.cells[cell].model, plan.cells[cell].n, plan.seed, plan.method, 0, plan.cells[cell].replicates, 64};
}

std::vector<GrownBlock> grow(const Plan& plan, std::size_t cell) {
  std::vector<GrownBlock> grown;
  const Cancellation never;
  grow_blocks({job_of(plan, cell)}, 1, never, [&](const Block& block, const BlockTrees& trees) {
    CellAccumulator sums(plan.statistics, plan.cells[cell].model.largest_order(plan.cells[cell].n));
    trees.each([&](std::uint64_t, const TreeMeasures& measures) { sums.add(measures); });
    grown.push_back({block, sums.sums()});
    grown.back().block.job = cell;
  });
  return grown;
}

std::string tables_of(CellResult result) {
  const auto cells = unchecked({{0, std::move(result)}});
  return write_csv(summary_table(cells)) + write_csv(orders_table(cells)) +
         write_csv(histograms_table(cells));
}

TEST(GrownBlock, TravelsWithoutLoss) {
  const Plan plan = small_plan();
  for (const GrownBlock& grown : grow(plan, 0)) {
    const auto arrived = decode_block(encode(grown), plan);
    ASSERT_TRUE(arrived);
    EXPECT_EQ(arrived->sums, grown.sums);
    EXPECT_EQ(arrived->block.first, grown.block.first);
    EXPECT_EQ(arrived->block.last, grown.block.last);
    EXPECT_EQ(arrived->block.index, grown.block.index);
  }
}

TEST(GrownBlock, BlocksThatTravelledGiveTheCellOfARun) {
  const Plan plan = small_plan();
  const Cell& cell = plan.cells[0];
  CellAccumulator total(plan.statistics, cell.model.largest_order(cell.n));
  const auto blocks = grow(plan, 0);
  EXPECT_EQ(blocks.size(), 5u);
  for (const GrownBlock& grown : blocks) total.merge(decode_block(encode(grown), plan)->sums);

  std::string run;
  RunObserver observer;
  observer.cell_done = [&](std::size_t index, const CellResult& result) {
    if (index == 0) run = tables_of(result);
  };
  const Cancellation never;
  const test::Scratch scratch;
  BlockStore store(scratch / "blocks.sqlite", plan);
  EXPECT_TRUE(run_cells(plan, store, 2, never, observer));
  EXPECT_GT(run.size(), 500u);
  EXPECT_EQ(tables_of(total.result(cell)), run);
}

TEST(GrownBlock, RefusesDamageAndOtherPlans) {
  const Plan plan = small_plan();
  const GrownBlock grown = grow(plan, 0).front();
  auto bytes = encode(grown);
  EXPECT_FALSE(decode_block(std::span(bytes).first(bytes.size() - 1), plan));
  EXPECT_FALSE(decode_block({}, plan));
  GrownBlock elsewhere = grown;
  elsewhere.block.job = 2;
  EXPECT_FALSE(decode_block(encode(elsewhere), plan));
  elsewhere.block = {1, 0, 41, 0};
  EXPECT_FALSE(decode_block(encode(elsewhere), plan));
  const std::vector<std::string> alone{"strahler"};
  Plan other = plan;
  other.statistics = StatisticSet::parse(alone);
  EXPECT_FALSE(decode_block(bytes, other));
}

}  // namespace
}  // namespace ramify
