#include "ramify/run/runner.hpp"

#include <mutex>
#include <optional>

#include "ramify/core/error.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

/// Of another process of the same build and plan.
GrownBlock handed_over(const Bytes& bytes, const Plan& plan) {
  if (auto grown = decode_block(bytes, plan)) return std::move(*grown);
  throw Error("a block of another process cannot be read", "it arrived damaged",
              "what was finished is kept: go on with --resume");
}

/// The blocks of a plan as work of a team; the process that leads says what it keeps them in.
SharedBlockWork shared_growing(const Plan& plan) {
  SharedBlockWork work;
  work.identity = identity_of(plan);
  work.send = [&plan](const Block& block, const BlockTrees& trees) {
    return encode(grown_block(plan, block, trees));
  };
  return work;
}

/// Puts the blocks together, as they come in, to cells. What is grown is kept.
class Assembly {
 public:
  /// Reports the cells of which the store has everything.
  Assembly(const Plan& plan, BlockStore& store, const RunObserver& observer)
      : plan_(plan), store_(store), observer_(observer), jobs_(jobs_of(plan)) {
    for (std::size_t c = 0; c < plan.cells.size(); ++c) {
      const Cell& cell = plan.cells[c];
      grown_nodes_.push_back(GraftRule(cell.model, plan.method).grown_nodes(cell.n));
      cells_.emplace_back();
      take_kept(c);
    }
    if (observer_.progress) observer_.progress(nodes_done_);
  }

  /// What is left to grow.
  const std::vector<GrowingJob>& jobs() const { return jobs_; }

  /// By any thread, in any order.
  void take(GrownBlock grown) {
    const std::lock_guard lock(mutex_);
    store_.save(grown);
    put(std::move(grown));
    if (observer_.progress) observer_.progress(nodes_done_);
  }

 private:
  struct OpenCell {
    std::vector<std::optional<CellSums>> blocks;
    std::size_t missing = 0;
  };

  void take_kept(std::size_t c) {
    const auto blocks = blocks_of(jobs_[c], c);
    if (const auto sums = store_.cell(c)) {
      for (const Block& block : blocks) jobs_[c].grown.insert(block.index);
      nodes_done_ += static_cast<double>(jobs_[c].last) * grown_nodes_[c];
      CellAccumulator total = no_trees(plan_, c);
      total.merge(*sums);
      report(c, total);
      return;
    }
    cells_[c] = {std::vector<std::optional<CellSums>>(blocks.size()), blocks.size()};
    for (GrownBlock& kept : store_.blocks(c)) {
      const Block& block = kept.block;
      if (block.index >= blocks.size() || blocks[block.index] != block) continue;  // grown again
      jobs_[c].grown.insert(block.index);
      put(std::move(kept));
    }
  }

  void put(GrownBlock grown) {
    const Block block = grown.block;
    OpenCell& open = cells_[block.job];
    nodes_done_ += static_cast<double>(block.trees()) * grown_nodes_[block.job];
    open.blocks[block.index] = std::move(grown.sums);
    if (--open.missing == 0) finish(block.job);
  }

  void finish(std::size_t c) {
    CellAccumulator total = no_trees(plan_, c);
    for (const auto& sums : cells_[c].blocks) total.merge(*sums);
    cells_[c].blocks.clear();
    store_.complete(c, total.sums());
    report(c, total);
  }

  void report(std::size_t c, const CellAccumulator& total) const {
    if (observer_.cell_done) observer_.cell_done(c, total.result(plan_.cells[c]));
  }

  const Plan& plan_;
  BlockStore& store_;
  const RunObserver& observer_;
  std::vector<GrowingJob> jobs_;
  std::vector<double> grown_nodes_;  // for a tree of each cell
  std::mutex mutex_;                 // guards all below
  std::vector<OpenCell> cells_;
  double nodes_done_ = 0;
};

}  // namespace

bool run_cells(const Plan& plan, BlockStore& store, const Workforce& workforce,
               const Cancellation& cancellation, const RunObserver& observer) {
  Assembly assembly(plan, store, observer);
  SharedBlockWork work = shared_growing(plan);
  work.keep = [&](const Block& block, const BlockTrees& trees) {
    assembly.take(grown_block(plan, block, trees));
  };
  work.take = [&](const Block&, const Bytes& outcome) { assembly.take(handed_over(outcome, plan)); };
  try {
    grow_blocks(assembly.jobs(), workforce, cancellation, work);
  } catch (const Interrupted&) {
    return false;  // blocks under way are lost
  }
  return true;
}

void help_run_cells(const Plan& plan, const Workforce& workforce, const Cancellation& cancellation) {
  grow_blocks(jobs_of(plan), workforce, cancellation, shared_growing(plan));
}

}  // namespace ramify
