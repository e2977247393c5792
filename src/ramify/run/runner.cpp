#include "ramify/run/runner.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/run/cell_accumulator.hpp"
#include "ramify/sample/graft_rule.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

/// Trees in a block: about a million grown nodes, so that the last blocks of a run do not leave threads idle.
std::uint64_t block_trees(double grown_nodes) {
  return static_cast<std::uint64_t>(std::clamp(0x1p20 / std::max(grown_nodes, 1.0), 1.0, 1024.0));
}

struct Block {
  std::size_t cell;
  std::uint64_t first, last;  // replicates first..last-1
  std::size_t index;          // within the cell
};

/// The blocks of a cell as they come in.
struct OpenCell {
  std::vector<std::optional<CellAccumulator>> blocks;
  std::size_t missing = 0;
};

class Run {
 public:
  Run(const Plan& plan, const std::vector<bool>& wanted, unsigned threads, const Cancellation& cancellation,
      const RunObserver& observer)
      : plan_(plan),
        cancellation_(cancellation),
        observer_(observer),
        samplers_(threads),
        open_(plan.cells.size()) {
    for (std::size_t c = 0; c < plan.cells.size(); ++c) {
      const Cell& cell = plan.cells[c];
      grown_nodes_.push_back(GraftRule(cell.model, plan.method).grown_nodes(cell.n));
      if (wanted[c]) add_blocks(c);
    }
    add_prototypes(wanted);
  }

  /// False where it was cancelled: blocks under way are lost, and with them their cells.
  bool execute() {
    try {
      parallel_for(blocks_.size(), static_cast<unsigned>(samplers_.size()),
                   [this](std::size_t b, unsigned worker) {
                     finish(blocks_[b], grow(blocks_[b], samplers_[worker]));
                   });
    } catch (const Interrupted&) {
      return false;
    }
    return true;
  }

 private:
  using Samplers = std::map<std::string, std::unique_ptr<TreeSampler>>;

  void add_blocks(std::size_t c) {
    const Cell& cell = plan_.cells[c];
    const std::uint64_t size = block_trees(grown_nodes_[c]);
    std::size_t index = 0;
    for (std::uint64_t first = 0; first < cell.replicates; first += size)
      blocks_.push_back({c, first, std::min(first + size, cell.replicates), index++});
    open_[c].blocks.resize(index);
    open_[c].missing = index;
  }

  void add_prototypes(const std::vector<bool>& wanted) {
    std::map<std::string, SamplerOrder> orders;
    for (std::size_t c = 0; c < plan_.cells.size(); ++c) {
      if (!wanted[c]) continue;
      const Cell& cell = plan_.cells[c];
      const SamplerOrder order{cell.model, plan_.method, cell.n, &cancellation_};
      auto& largest = orders.try_emplace(cell.model.text(), order).first->second.largest_n;
      largest = std::max(largest, cell.n);
    }
    for (const auto& [text, order] : orders) prototypes_[text] = make_tree_sampler(order);
  }

  CellAccumulator grow(const Block& block, Samplers& samplers) const {
    const Cell& cell = plan_.cells[block.cell];
    auto& sampler = samplers[cell.model.text()];
    if (!sampler) sampler = prototypes_.at(cell.model.text())->clone();
    const StreamKey key{plan_.seed, cell.model.stream_cell(cell.n)};
    CellAccumulator sums(plan_.statistics, cell.model.largest_order(cell.n));
    TreeMeasures measures;
    for (std::uint64_t replicate = block.first; replicate < block.last; ++replicate) {
      if (cancellation_.requested()) throw Interrupted();
      sampler->sample(cell.n, key, replicate, measures);
      sums.add(measures);
    }
    return sums;
  }

  void finish(const Block& block, CellAccumulator sums) {
    const Cell& cell = plan_.cells[block.cell];
    const std::lock_guard lock(mutex_);
    nodes_done_ += static_cast<double>(block.last - block.first) * grown_nodes_[block.cell];
    OpenCell& open = open_[block.cell];
    open.blocks[block.index] = std::move(sums);
    if (observer_.progress) observer_.progress(nodes_done_);
    if (--open.missing > 0) return;
    CellAccumulator total(plan_.statistics, cell.model.largest_order(cell.n));
    for (const auto& part : open.blocks) total.merge(*part);
    open.blocks.clear();
    if (observer_.cell_done) observer_.cell_done(block.cell, total.result(cell));
  }

  const Plan& plan_;
  const Cancellation& cancellation_;
  const RunObserver& observer_;
  std::vector<double> grown_nodes_;  // for a tree of each cell
  std::vector<Block> blocks_;
  Samplers prototypes_;
  std::vector<Samplers> samplers_;  // one set for each thread
  std::mutex mutex_;                // guards all below
  std::vector<OpenCell> open_;
  double nodes_done_ = 0;
};

}  // namespace

bool run_cells(const Plan& plan, const std::vector<bool>& wanted, unsigned threads,
               const Cancellation& cancellation, const RunObserver& observer) {
  return Run(plan, wanted, threads, cancellation, observer).execute();
}

}  // namespace ramify
