#include "ramify/run/runner.hpp"

#include <mutex>
#include <optional>

#include "ramify/core/error.hpp"
#include "ramify/run/grown_block.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

/// Puts the blocks together, as they come in, to cells.
class Assembly {
 public:
  Assembly(const Plan& plan, const std::vector<GrowingJob>& jobs, const RunObserver& observer)
      : plan_(plan), observer_(observer) {
    for (std::size_t c = 0; c < jobs.size(); ++c) {
      const std::size_t blocks = blocks_of(jobs[c], c).size();
      cells_.push_back({std::vector<std::optional<CellSums>>(blocks), blocks});
      grown_nodes_.push_back(GraftRule(jobs[c].model, jobs[c].method).grown_nodes(jobs[c].n));
    }
  }

  /// By any thread, in any order.
  void take(GrownBlock grown) {
    const Block& block = grown.block;
    const std::lock_guard lock(mutex_);
    nodes_done_ += static_cast<double>(block.trees()) * grown_nodes_[block.job];
    OpenCell& open = cells_[block.job];
    open.blocks[block.index] = std::move(grown.sums);
    if (observer_.progress) observer_.progress(nodes_done_);
    if (--open.missing == 0) finish(block.job);
  }

 private:
  struct OpenCell {
    std::vector<std::optional<CellSums>> blocks;
    std::size_t missing;
  };

  void finish(std::size_t c) {
    const Cell& cell = plan_.cells[c];
    CellAccumulator total(plan_.statistics, cell.model.largest_order(cell.n));
    for (const auto& sums : cells_[c].blocks) total.merge(*sums);
    cells_[c].blocks.clear();
    if (observer_.cell_done) observer_.cell_done(c, total.result(cell));
  }

  const Plan& plan_;
  const RunObserver& observer_;
  std::vector<double> grown_nodes_;  // for a tree of each cell
  std::mutex mutex_;                 // guards all below
  std::vector<OpenCell> cells_;
  double nodes_done_ = 0;
};

/// A job for each cell; one without trees where the cell is not wanted.
std::vector<GrowingJob> jobs_of(const Plan& plan, const std::vector<bool>& wanted) {
  std::vector<GrowingJob> jobs;
  for (std::size_t c = 0; c < plan.cells.size(); ++c) {
    const Cell& cell = plan.cells[c];
    jobs.push_back({cell.model, cell.n, plan.seed, plan.method, 0, wanted[c] ? cell.replicates : 0});
  }
  return jobs;
}

}  // namespace

bool run_cells(const Plan& plan, const std::vector<bool>& wanted, unsigned threads,
               const Cancellation& cancellation, const RunObserver& observer) {
  const auto jobs = jobs_of(plan, wanted);
  Assembly assembly(plan, jobs, observer);
  try {
    grow_blocks(jobs, threads, cancellation, [&](const Block& block, const BlockTrees& trees) {
      const Cell& cell = plan.cells[block.job];
      CellAccumulator sums(plan.statistics, cell.model.largest_order(cell.n));
      trees.each([&](std::uint64_t, const TreeMeasures& measures) { sums.add(measures); });
      assembly.take({block, sums.sums()});
    });
  } catch (const Interrupted&) {
    return false;  // blocks under way are lost, and with them their cells
  }
  return true;
}

}  // namespace ramify
